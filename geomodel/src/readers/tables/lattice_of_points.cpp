// SPDX-License-Identifier: GPL-3.0-or-later
// Recognises points of a table that form a regular grid.
#include <algorithm>
#include <cmath>
#include <limits>

#include "readers/tables/table.hpp"

namespace geomesh::geomodel {
namespace {

/// Positions of grid nodes along one axis, which are multiples of one spacing up to the rounding of the file.
struct Axis {
  double first = 0, spacing = 0;
  std::size_t n = 0;

  std::size_t node(double v) const { return static_cast<std::size_t>(std::llround((v - first) / spacing)); }
};

/// Largest distance of a point from its grid position, as a share of the spacing: files round coordinates, some to
/// single precision.
constexpr double most_off = 0.02;

std::optional<Axis> regular_axis(const std::vector<Vec3>& points, std::size_t k) {
  std::vector<double> at;
  at.reserve(points.size());
  for (const Vec3& p : points) at.push_back(p[k]);
  std::sort(at.begin(), at.end());
  double largest_gap = 0;
  for (std::size_t i = 1; i < at.size(); ++i) largest_gap = std::max(largest_gap, at[i] - at[i - 1]);
  double smallest_step = largest_gap;
  for (std::size_t i = 1; i < at.size(); ++i)
    if (at[i] - at[i - 1] > most_off * largest_gap) smallest_step = std::min(smallest_step, at[i] - at[i - 1]);
  if (!(smallest_step > 0)) return std::nullopt;
  const double n_steps = std::round((at.back() - at.front()) / smallest_step);
  if (n_steps > 4.0 * static_cast<double>(points.size())) return std::nullopt;
  Axis axis{at.front(), (at.back() - at.front()) / n_steps, static_cast<std::size_t>(n_steps) + 1};
  for (const double v : at)
    if (std::abs(v - (axis.first + static_cast<double>(axis.node(v)) * axis.spacing)) > most_off * axis.spacing)
      return std::nullopt;
  return axis.n < 2 ? std::nullopt : std::optional(axis);
}

}  // namespace

std::optional<NodeLattice> lattice_of_points(const std::vector<Vec3>& points) {
  if (points.size() < 4) return std::nullopt;
  const auto x = regular_axis(points, 0), y = regular_axis(points, 1);
  if (!x || !y || x->n > 4 * points.size() / y->n) return std::nullopt;
  NodeLattice lattice{x->n, y->n, {}};
  for (std::size_t j = 0; j < y->n; ++j)
    for (std::size_t i = 0; i < x->n; ++i)
      lattice.nodes.push_back({x->first + static_cast<double>(i) * x->spacing,
                               y->first + static_cast<double>(j) * y->spacing,
                               std::numeric_limits<double>::quiet_NaN()});
  for (const Vec3& p : points) {
    Vec3& node = lattice.nodes[y->node(p.y) * x->n + x->node(p.x)];
    if (!std::isnan(node.z) && node != p) return std::nullopt;  // two points at the same node: they form no grid
    node = p;
  }
  return lattice;
}

}  // namespace geomesh::geomodel
