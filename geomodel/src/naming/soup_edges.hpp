// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The edges of a polygon soup with the facets that meet there, and the surface sets of its facets.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "geomesh/geomodel/arrangement.hpp"

namespace geomesh::geomodel {

/// One facet at one edge, a < b.
struct EdgeUse {
  VertexIndex a, b;
  Index facet;
};

/// All uses, sorted by (a, b, facet). O(n log n).
std::vector<EdgeUse> sorted_edge_uses(const PolygonSoup& soup);

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

/// The different sets of surfaces that facets stand for, in the order of their first facet; each ascending.
struct SurfaceSets {
  std::vector<std::vector<Index>> sets;
  std::vector<Index> of_facet;  ///< row in `sets`
};
SurfaceSets surface_sets(const PolygonSoup& soup);

}  // namespace geomesh::geomodel
