// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_sets/fields/grid_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace geomesh::geomodel {
namespace {

constexpr Range nothing{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

Range joined(const Range& a, const Range& b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

}  // namespace

GridField::GridField(Lattice lattice) : lattice_(std::move(lattice)) { build_levels(); }

double GridField::node_coordinate(std::size_t axis, std::size_t i) const {
  return lattice_.origin[axis] + static_cast<double>(i) * lattice_.spacing[axis];
}

Box3 GridField::domain() const {
  Box3 box;
  box.add(lattice_.origin);
  box.add({node_coordinate(0, lattice_.n[0] - 1), node_coordinate(1, lattice_.n[1] - 1),
           node_coordinate(2, lattice_.n[2] - 1)});
  return box;
}

double GridField::resolution() const { return std::min({lattice_.spacing.x, lattice_.spacing.y, lattice_.spacing.z}); }

std::size_t GridField::cell_of(std::size_t axis, double x) const {
  const double at = std::floor((x - lattice_.origin[axis]) / lattice_.spacing[axis]);
  return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(lattice_.n[axis] - 2)));
}

double GridField::in_cell(const std::array<std::size_t, 3>& cell, const Vec3& p) const {
  double share[3];
  for (std::size_t a = 0; a < 3; ++a) share[a] = (p[a] - node_coordinate(a, cell[a])) / lattice_.spacing[a];
  const auto along_x = [&](std::size_t j, std::size_t k) {
    const double left = node(cell[0], j, k), right = node(cell[0] + 1, j, k);
    return (1 - share[0]) * left + share[0] * right;
  };
  const auto along_y = [&](std::size_t k) {
    return (1 - share[1]) * along_x(cell[1], k) + share[1] * along_x(cell[1] + 1, k);
  };
  return (1 - share[2]) * along_y(cell[2]) + share[2] * along_y(cell[2] + 1);
}

double GridField::at(const Vec3& p) const { return in_cell({cell_of(0, p.x), cell_of(1, p.y), cell_of(2, p.z)}, p); }

void GridField::values(std::span<const Vec3> places, std::span<double> out) const {
  for (std::size_t i = 0; i < places.size(); ++i) out[i] = at(places[i]);
}

GridField::Cells GridField::cells_of(const Box3& box) const {
  Cells cells;
  for (std::size_t a = 0; a < 3; ++a) cells[a] = {cell_of(a, box.min[a]), cell_of(a, box.max[a])};
  return cells;
}

void GridField::build_levels() {
  Level cells;
  cells.n = {lattice_.n[0] - 1, lattice_.n[1] - 1, lattice_.n[2] - 1};
  cells.blocks.reserve(cells.n[0] * cells.n[1] * cells.n[2]);
  for (std::size_t k = 0; k < cells.n[2]; ++k)
    for (std::size_t j = 0; j < cells.n[1]; ++j)
      for (std::size_t i = 0; i < cells.n[0]; ++i) {
        Range range = nothing;
        for (std::size_t corner = 0; corner < 8; ++corner) {
          const double v = node(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2));
          range = joined(range, {v, v});
        }
        cells.blocks.push_back(range);
      }
  levels_.push_back(std::move(cells));
  while (levels_.back().blocks.size() > 1) levels_.push_back(coarser(levels_.back()));
}

GridField::Level GridField::coarser(const Level& fine) {
  Level level;
  for (std::size_t a = 0; a < 3; ++a) level.n[a] = (fine.n[a] + 1) / 2;
  level.blocks.assign(level.n[0] * level.n[1] * level.n[2], nothing);
  for (std::size_t k = 0; k < fine.n[2]; ++k)
    for (std::size_t j = 0; j < fine.n[1]; ++j)
      for (std::size_t i = 0; i < fine.n[0]; ++i) {
        Range& block = level.blocks[i / 2 + level.n[0] * (j / 2 + level.n[1] * (k / 2))];
        block = joined(block, fine.blocks[i + fine.n[0] * (j + fine.n[1] * k)]);
      }
  return level;
}

/// Returns bounds of the field in a box from the coarseness level at which the box overlaps at most three blocks along
/// each axis. Bounds for a box much larger than a cell are therefore coarse, but take constant time.
Range GridField::value_range(const Box3& box) const {
  const Cells cells = cells_of(box);
  std::size_t level = 0;
  const auto is_wide = [&](std::size_t a) { return (cells[a][1] >> level) - (cells[a][0] >> level) > 2; };
  while (level + 1 < levels_.size() && (is_wide(0) || is_wide(1) || is_wide(2))) ++level;
  const Level& found = levels_[level];
  Range range = nothing;
  for (std::size_t k = cells[2][0] >> level; k <= cells[2][1] >> level; ++k)
    for (std::size_t j = cells[1][0] >> level; j <= cells[1][1] >> level; ++j)
      for (std::size_t i = cells[0][0] >> level; i <= cells[0][1] >> level; ++i)
        range = joined(range, found.blocks[i + found.n[0] * (j + found.n[1] * k)]);
  return range;
}

/// Returns bounds of the field minus a linear function in a box, by evaluating the corners of the box's intersection
/// with each grid cell.
Range GridField::residual_range(const Box3& box, const LinearFunction& linear) const {
  const Cells cells = cells_of(box);
  Range range = nothing;
  std::array<std::size_t, 3> cell;
  for (cell[2] = cells[2][0]; cell[2] <= cells[2][1]; ++cell[2])
    for (cell[1] = cells[1][0]; cell[1] <= cells[1][1]; ++cell[1])
      for (cell[0] = cells[0][0]; cell[0] <= cells[0][1]; ++cell[0]) {
        Box3 part;
        for (std::size_t a = 0; a < 3; ++a) {
          part.min[a] = cell[a] == cells[a][0] ? box.min[a] : node_coordinate(a, cell[a]);
          part.max[a] = cell[a] == cells[a][1] ? box.max[a] : node_coordinate(a, cell[a] + 1);
        }
        for (std::size_t corner = 0; corner < 8; ++corner) {
          const Vec3 p{corner & 1 ? part.max.x : part.min.x, corner & 2 ? part.max.y : part.min.y,
                       corner & 4 ? part.max.z : part.min.z};
          const double residual = in_cell(cell, p) - linear(p);
          range = joined(range, {residual, residual});
        }
      }
  return range;
}

}  // namespace geomesh::geomodel
