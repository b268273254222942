// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_sets/mesh/crossed_edges.hpp"

#include <algorithm>
#include <utility>

#include "common/parallel.hpp"

namespace geomesh::geomodel {
namespace {

std::pair<VertexIndex, VertexIndex> ends(const CrossedEdges::Edge& e) {
  return {std::min(e.below, e.above), std::max(e.below, e.above)};
}

}  // namespace

MovedVertices::MovedVertices(const BackgroundMesh& mesh, std::vector<double> shift_of_values)
    : shift(std::move(shift_of_values)), is_moved(mesh.n_points(), 0) {
  for (VertexIndex v = 0; v < mesh.n_points(); ++v) {
    points.push_back(mesh.point(v));
    values.push_back(mesh.value(v) - shift[v]);
  }
}

CrossedEdges::CrossedEdges(const BackgroundMesh& mesh, const MovedVertices& vertices, const ScalarField* field,
                           const std::vector<double>& values, const CrossedEdges* known) {
  collect(mesh, vertices, values);
  roots_.assign(values.size(), std::vector<Vec3>(edges_.size()));
  for (std::size_t v = 0; v < values.size(); ++v) solve(v, vertices, field, values, known);
}

void CrossedEdges::collect(const BackgroundMesh& mesh, const MovedVertices& vertices,
                           const std::vector<double>& values) {
  for (const BackgroundMesh::Cell& cell : mesh.cells())
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) {
        Edge edge{cell.v[i], cell.v[j]};
        if (vertices.values[edge.below] > vertices.values[edge.above]) std::swap(edge.below, edge.above);
        const auto value = std::upper_bound(values.begin(), values.end(), vertices.values[edge.below]);
        if (value != values.end() && *value <= vertices.values[edge.above]) edges_.push_back(edge);
      }
  parallel_sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) { return ends(a) < ends(b); });
  const auto is_same = [](const Edge& a, const Edge& b) { return ends(a) == ends(b); };
  edges_.erase(std::unique(edges_.begin(), edges_.end(), is_same), edges_.end());
}

std::size_t CrossedEdges::row(VertexIndex a, VertexIndex b) const {
  const std::pair<VertexIndex, VertexIndex> wanted(std::min(a, b), std::max(a, b));
  const auto at = std::lower_bound(edges_.begin(), edges_.end(), wanted,
                                   [](const Edge& edge, const auto& pair) { return ends(edge) < pair; });
  return static_cast<std::size_t>(at - edges_.begin());
}

bool CrossedEdges::is_known(const Edge& edge, const MovedVertices& vertices) const {
  return !vertices.is_moved[edge.below] && !vertices.is_moved[edge.above];
}

/// Returns the interval of an edge in which an isosurface crosses it: above the crossing of the previous isovalue, so
/// that crossings have the order of the values even if the field is not monotonic along the edge.
Bracket CrossedEdges::bracket(std::size_t v, std::size_t e, const MovedVertices& vertices,
                              const std::vector<double>& values) const {
  const auto [below, above] = edges_[e];
  Bracket b{vertices.points[below], vertices.points[above], vertices.values[below], vertices.values[above], values[v],
            vertices.shift[below],  vertices.shift[above]};
  if (v == 0 || !crosses(edges_[e], values[v - 1], vertices)) return b;
  const double share = length_of(roots_[v - 1][e] - b.below) / length_of(b.above - b.below);
  b.shift_below += share * (b.shift_above - b.shift_below);
  b.below = roots_[v - 1][e];
  b.value_below = values[v - 1];
  return b;
}

void CrossedEdges::solve(std::size_t v, const MovedVertices& vertices, const ScalarField* field,
                         const std::vector<double>& values, const CrossedEdges* known) {
  std::vector<Bracket> brackets;
  std::vector<std::size_t> rows;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const Edge& edge = edges_[e];
    if (!crosses(edge, values[v], vertices)) continue;
    if (values[v] == vertices.values[edge.above]) {
      roots_[v][e] = vertices.points[edge.above];
    } else if (known && is_known(edge, vertices)) {
      roots_[v][e] = known->root(v, known->row(edge.below, edge.above));
    } else {
      brackets.push_back(bracket(v, e, vertices, values));
      rows.push_back(e);
    }
  }
  const std::vector<Vec3> found = field ? find_roots(*field, std::move(brackets)) : linear_roots(brackets);
  for (std::size_t i = 0; i < rows.size(); ++i) roots_[v][rows[i]] = found[i];
}

}  // namespace geomesh::geomodel
