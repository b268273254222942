// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/patches/surface_sets.hpp"

#include <algorithm>
#include <map>

namespace geomesh::geomodel {

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
