// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Connected sets of facets of one arrangement. Which side of a surface they lie on is decided once for each set.
#pragma once

#include <algorithm>
#include <tuple>
#include <vector>

#include "arrangement/clip/clip.hpp"

namespace geomesh::geomodel::arrangement {

struct FacetEdge {
  VertexIndex a, b;
  Index facet;
  bool operator<(const FacetEdge& o) const { return std::tie(a, b, facet) < std::tie(o.a, o.b, o.facet); }
};

/// Returns for each facet the index of its connected component, or no_index if it is not `chosen`. Chosen facets are
/// connected across the edges for which `passes` returns true when it is called with all chosen and `barrier` facets at
/// the edge. Components are numbered from 0 in the order of their least facet indices.
template <typename Passes>
std::vector<Index> components(const Arranged& arranged, const std::vector<std::uint8_t>& chosen,
                              const std::vector<std::uint8_t>& barrier, Passes&& passes) {
  std::vector<FacetEdge> edges;
  for (Index f = 0; f < arranged.facets.size(); ++f) {
    if (!chosen[f] && !barrier[f]) continue;
    const Triangle& t = arranged.facets[f];
    for (std::size_t k = 0; k < 3; ++k)
      edges.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]), f});
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Index> parent(arranged.facets.size());
  for (Index f = 0; f < parent.size(); ++f) parent[f] = f;
  const auto root = [&parent](Index f) {
    while (parent[f] != f) f = parent[f] = parent[parent[f]];
    return f;
  };
  for (std::size_t begin = 0, end; begin < edges.size(); begin = end) {
    for (end = begin + 1; end < edges.size() && edges[end].a == edges[begin].a && edges[end].b == edges[begin].b;)
      ++end;
    if (!passes(std::span<const FacetEdge>(edges.data() + begin, end - begin))) continue;
    for (std::size_t e = begin + 1; e < end; ++e) {
      const Index a = root(edges[begin].facet), b = root(edges[e].facet);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<Index> component(arranged.facets.size(), no_index);
  Index n = 0;
  for (Index f = 0; f < component.size(); ++f)
    if (chosen[f]) component[f] = root(f) == f ? n++ : component[root(f)];
  return component;
}

/// Returns the largest facet of each component (the first of equals), on which a winding number is reliable. Merging
/// bends walls away from the triangles of which winding numbers are computed, so a sliver may seem to be on another
/// side than the rest of its component. O(n).
inline std::vector<Index> largest_facets(const Arranged& arranged, const std::vector<Index>& component) {
  std::vector<Index> largest;
  std::vector<double> areas;
  for (Index f = 0; f < component.size(); ++f) {
    if (component[f] == no_index) continue;
    const double area = facet_area(arranged, f);
    if (component[f] == largest.size()) {
      largest.push_back(f);
      areas.push_back(area);
    } else if (area > areas[component[f]]) {
      largest[component[f]] = f;
      areas[component[f]] = area;
    }
  }
  return largest;
}

inline ExactPoint facet_centroid(const Arranged& arranged, const Triangle& t) {
  return centroid(arranged.vertices.exact(t[0]), arranged.vertices.exact(t[1]), arranged.vertices.exact(t[2]));
}

}  // namespace geomesh::geomodel::arrangement
