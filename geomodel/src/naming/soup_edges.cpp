// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/soup_edges.hpp"

#include <map>
#include <tuple>

namespace geomesh::geomodel {

std::vector<EdgeUse> sorted_edge_uses(const PolygonSoup& soup) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * soup.facets.size());
  for (Index f = 0; f < soup.facets.size(); ++f) {
    const Triangle& t = soup.facets[f];
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

SurfaceSets surface_sets(const PolygonSoup& soup) {
  SurfaceSets result;
  std::map<std::vector<Index>, Index> rows;
  std::vector<Index> set;
  for (Index f = 0; f < soup.facets.size(); ++f) {
    set.clear();
    for (Index o = soup.origin_offsets[f]; o < soup.origin_offsets[f + 1]; ++o) set.push_back(soup.origins[o].surface);
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
    const auto [at, is_new] = rows.emplace(set, static_cast<Index>(result.sets.size()));
    if (is_new) result.sets.push_back(set);
    result.of_facet.push_back(at->second);
  }
  return result;
}

}  // namespace geomesh::geomodel
