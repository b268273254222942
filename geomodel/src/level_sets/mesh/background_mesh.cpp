// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_sets/mesh/background_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace geomesh::geomodel {
namespace {

constexpr std::array<std::array<std::size_t, 2>, 6> edges_of_cell{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

std::uint8_t sides_at(const Box3& box, const Vec3& p) {
  unsigned sides = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    if (p[a] == box.min[a]) sides |= 1u << 2 * a;
    if (p[a] == box.max[a]) sides |= 2u << 2 * a;
  }
  return static_cast<std::uint8_t>(sides);
}

}  // namespace

BackgroundMesh::BackgroundMesh(const ScalarField& field, const Box3& box, double edge) : field_(&field), box_(box) {
  std::array<std::size_t, 3> n;
  for (std::size_t a = 0; a < 3; ++a)
    n[a] = static_cast<std::size_t>(std::max(1.0, std::round((box.max[a] - box.min[a]) / edge)));
  add_cubes(n);
  evaluate();
}

BackgroundMesh::BackgroundMesh(std::vector<Vec3> points, std::vector<double> values,
                               const std::vector<Tetrahedron>& cells)
    : points_(std::move(points)), values_(std::move(values)), sides_(points_.size(), 0) {
  is_vertex_.assign(points_.size(), 1);
  n_evaluated_ = points_.size();
  for (const Tetrahedron& t : cells) cells_.push_back({t, 3});
}

void BackgroundMesh::add_cubes(const std::array<std::size_t, 3>& n) {
  const auto coordinate = [&](std::size_t a, std::size_t i) {
    if (i == n[a]) return box_.max[a];
    return box_.min[a] + static_cast<double>(i) / static_cast<double>(n[a]) * (box_.max[a] - box_.min[a]);
  };
  for (std::size_t k = 0; k <= n[2]; ++k)
    for (std::size_t j = 0; j <= n[1]; ++j)
      for (std::size_t i = 0; i <= n[0]; ++i) points_.push_back({coordinate(0, i), coordinate(1, j), coordinate(2, k)});
  is_vertex_.assign(points_.size(), 1);
  const std::array<std::size_t, 3> step{1, n[0] + 1, (n[0] + 1) * (n[1] + 1)};
  constexpr std::array<std::array<std::size_t, 3>, 6> paths{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  for (std::size_t k = 0; k < n[2]; ++k)
    for (std::size_t j = 0; j < n[1]; ++j)
      for (std::size_t i = 0; i < n[0]; ++i)
        for (const auto& path : paths) {
          Cell cell{{}, 3};
          std::size_t v = i + step[1] * j + step[2] * k;
          cell.v[0] = static_cast<VertexIndex>(v);
          for (std::size_t s = 0; s < 3; ++s) cell.v[s + 1] = static_cast<VertexIndex>(v += step[path[s]]);
          cells_.push_back(cell);
        }
}

std::array<Vec3, 4> BackgroundMesh::corners(const Cell& cell) const {
  return {points_[cell.v[0]], points_[cell.v[1]], points_[cell.v[2]], points_[cell.v[3]]};
}

double BackgroundMesh::longest_edge(const std::array<Vec3, 4>& corners) {
  double longest = 0;
  for (const auto& [i, j] : edges_of_cell) {
    const Vec3 edge = corners[j] - corners[i];
    longest = std::max(longest, dot(edge, edge));
  }
  return std::sqrt(longest);
}

VertexIndex BackgroundMesh::midpoint(VertexIndex a, VertexIndex b) {
  const auto [it, is_new] = midpoints_.try_emplace(key(a, b), static_cast<VertexIndex>(points_.size()));
  if (is_new) {
    points_.push_back(0.5 * (points_[a] + points_[b]));
    is_vertex_.push_back(0);
  }
  return it->second;
}

void BackgroundMesh::evaluate() {
  values_.resize(points_.size());
  if (n_evaluated_ == points_.size()) return;
  const std::size_t n = points_.size() - n_evaluated_;
  field_->values({points_.data() + n_evaluated_, n}, {values_.data() + n_evaluated_, n});
  for (std::size_t v = n_evaluated_; v < points_.size(); ++v) sides_.push_back(sides_at(box_, points_[v]));
  n_evaluated_ = points_.size();
}

void BackgroundMesh::sample_midpoints() {
  for (const Cell& cell : cells_) {
    if (cell.is_settled) continue;
    for (const auto& [i, j] : edges_of_cell) midpoint(cell.v[i], cell.v[j]);
  }
  evaluate();
}

void BackgroundMesh::bisect_cell(std::size_t row) {
  const Cell cell = cells_[row];
  const VertexIndex a = cell.v[0], b = cell.v[cell.tag];
  const VertexIndex m = midpoint(a, b);
  if (!is_vertex_[m]) fresh_cuts_.push_back({a, b});
  is_vertex_[m] = 1;
  Cell first{cell.v, 3}, second{cell.v, 3};
  first.tag = second.tag = cell.tag > 1 ? static_cast<std::uint8_t>(cell.tag - 1) : std::uint8_t{3};
  first.v[cell.tag] = m;
  for (std::size_t i = 0; i < cell.tag; ++i) second.v[i] = cell.v[i + 1];
  second.v[cell.tag] = m;
  cells_[row] = first;
  cells_.push_back(second);
}

bool BackgroundMesh::has_bisected_edge(const Cell& cell) const {
  int n_near = 0;
  for (const VertexIndex v : cell.v) n_near += is_near_cut_[v];
  if (n_near < 2) return false;
  return std::any_of(edges_of_cell.begin(), edges_of_cell.end(), [&](const auto& edge) {
    const VertexIndex a = cell.v[edge[0]], b = cell.v[edge[1]];
    if (!is_near_cut_[a] || !is_near_cut_[b]) return false;
    const auto at = midpoints_.find(key(a, b));
    return at != midpoints_.end() && is_vertex_[at->second];
  });
}

/// Bisects cells until the mesh is conforming. Only cells with both ends of an edge that was bisected in the last sweep
/// are examined, because no others can be non-conforming.
void BackgroundMesh::conform() {
  while (!fresh_cuts_.empty()) {
    is_near_cut_.assign(points_.size(), 0);
    for (const auto& cut : fresh_cuts_)
      for (const VertexIndex v : cut) is_near_cut_[v] = 1;
    fresh_cuts_.clear();
    for (std::size_t c = 0, n = cells_.size(); c < n; ++c) {
      if (!has_bisected_edge(cells_[c])) continue;
      bisect_cell(c);
      // The two halves of a bisected cell may still contain a bisected edge, so they are examined in the next sweep.
      for (const auto& [i, j] : edges_of_cell) fresh_cuts_.push_back({cells_[c].v[i], cells_[c].v[j]});
      for (const auto& [i, j] : edges_of_cell) fresh_cuts_.push_back({cells_.back().v[i], cells_.back().v[j]});
      is_near_cut_.resize(points_.size(), 0);
    }
  }
}

void BackgroundMesh::bisect(const std::vector<std::size_t>& cells) {
  for (const std::size_t c : cells) bisect_cell(c);
  conform();
  evaluate();
}

}  // namespace geomesh::geomodel
