// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The edges of a set of triangles with the triangles that meet there.
#pragma once

#include <algorithm>
#include <span>
#include <tuple>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// One facet at one edge, a < b.
struct EdgeUse {
  VertexIndex a, b;
  Index facet;  ///< row of the triangle
};

/// All uses, sorted by (a, b, facet). O(n log n).
inline std::vector<EdgeUse> sorted_edge_uses(std::span<const Triangle> triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (Index f = 0; f < triangles.size(); ++f) {
    const Triangle& t = triangles[f];
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexIndex p = t[i], q = t[(i + 1) % 3];
      uses.push_back({std::min(p, q), std::max(p, q), f});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& p, const EdgeUse& q) {
    return std::tie(p.a, p.b, p.facet) < std::tie(q.a, q.b, q.facet);
  });
  return uses;
}

/// Calls visit(span of uses) once for each edge, in the order of sorted_edge_uses.
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
