// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Lists the edges of a set of triangles, with the triangles that meet at each edge.
#pragma once

#include <algorithm>
#include <compare>
#include <span>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// A triangle at an edge of the surface whose ends are the vertices a < b.
struct EdgeUse {
  VertexIndex a, b;
  Index facet;
  friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

/// Returns one entry for each triangle at each edge, sorted by (a, b, facet). `triangle_of` returns the triangle with a
/// given index below n. O(n log n).
template <class TriangleOf>
std::vector<EdgeUse> sorted_edge_uses(std::size_t n, const TriangleOf& triangle_of) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * n);
  for (Index f = 0; f < n; ++f) {
    const Triangle& t = triangle_of(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexIndex p = t[i], q = t[(i + 1) % 3];
      uses.push_back({std::min(p, q), std::max(p, q), f});
    }
  }
  std::sort(uses.begin(), uses.end());
  return uses;
}
inline std::vector<EdgeUse> sorted_edge_uses(std::span<const Triangle> triangles) {
  return sorted_edge_uses(triangles.size(), [&](Index f) -> const Triangle& { return triangles[f]; });
}
inline std::vector<EdgeUse> sorted_edge_uses(const std::vector<ModelMesh::Face>& faces) {
  return sorted_edge_uses(faces.size(), [&](Index f) -> const Triangle& { return faces[f].vertices; });
}

/// Calls visit(entries) once for each edge, with its entries in `uses`: one for each triangle at the edge.
/// Precondition: `uses` is sorted by edge, as by sorted_edge_uses.
template <class F>
void for_each_edge(const std::vector<EdgeUse>& uses, F&& visit) {
  for (std::size_t begin = 0; begin < uses.size();) {
    std::size_t end = begin + 1;
    while (end < uses.size() && uses[end].a == uses[begin].a && uses[end].b == uses[begin].b) ++end;
    visit(std::span<const EdgeUse>(uses.data() + begin, end - begin));
    begin = end;
  }
}

}  // namespace geomesh::geomodel
