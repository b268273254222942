// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Lists the edges of a polygon soup with the facets at each.
#pragma once

#include <algorithm>
#include <vector>

#include "geomesh/geomodel/arrangement.hpp"

namespace geomesh::geomodel::arrangement {

/// Edges of a polygon soup in buckets by their smaller vertex index, each bucket sorted. Built in linear time.
class EdgeBuckets {
 public:
  explicit EdgeBuckets(const PolygonSoup& soup) : begin_(soup.points.size() + 1, 0), edges_(3 * soup.facets.size()) {
    for_each_side(soup, [this](VertexIndex a, VertexIndex, Index) { ++begin_[a + 1]; });
    for (std::size_t v = 0; v + 1 < begin_.size(); ++v) begin_[v + 1] += begin_[v];
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for_each_side(soup, [&](VertexIndex a, VertexIndex b, Index f) { edges_[next[a]++] = {b, f}; });
    for (std::size_t v = 0; v + 1 < begin_.size(); ++v)
      std::sort(edges_.begin() + static_cast<std::ptrdiff_t>(begin_[v]),
                edges_.begin() + static_cast<std::ptrdiff_t>(begin_[v + 1]),
                [](const FacetAtEdge& x, const FacetAtEdge& y) {
                  return x.other != y.other ? x.other < y.other : x.facet < y.facet;
                });
  }

  /// Calls visit(a, b, facets) for each edge (a, b) with a < b; its facets are ascending.
  template <typename Visit>
  void for_each_edge(Visit&& visit) const {
    std::vector<Index> facets;
    for (VertexIndex a = 0; a + 1 < begin_.size(); ++a)
      for (std::size_t k = begin_[a]; k < begin_[a + 1];) {
        const VertexIndex b = edges_[k].other;
        for (facets.clear(); k < begin_[a + 1] && edges_[k].other == b; ++k) facets.push_back(edges_[k].facet);
        visit(a, b, facets);
      }
  }

 private:
  struct FacetAtEdge {
    VertexIndex other;
    Index facet;
  };
  template <typename Visit>
  static void for_each_side(const PolygonSoup& soup, Visit&& visit) {
    for (Index f = 0; f < soup.facets.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k) {
        const VertexIndex a = soup.facets[f][k], b = soup.facets[f][(k + 1) % 3];
        visit(std::min(a, b), std::max(a, b), f);
      }
  }
  std::vector<std::size_t> begin_;
  std::vector<FacetAtEdge> edges_;
};

}  // namespace geomesh::geomodel::arrangement
