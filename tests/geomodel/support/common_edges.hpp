// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Edges of a soup at which two surfaces meet.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "geomesh/geomodel/arrangement.hpp"

namespace geomesh::geomodel::testing {

/// Edges at which facets of both surfaces lie.
inline std::vector<std::pair<VertexIndex, VertexIndex>> common_edges(const PolygonSoup& soup, Index a, Index b) {
  std::map<std::pair<VertexIndex, VertexIndex>, std::set<Index>> surfaces_at;
  for (Index f = 0; f < soup.facets.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      for (Index o = soup.origin_offsets[f]; o < soup.origin_offsets[f + 1]; ++o)
        surfaces_at[std::minmax(soup.facets[f][k], soup.facets[f][(k + 1) % 3])].insert(soup.origins[o].surface);
  std::vector<std::pair<VertexIndex, VertexIndex>> edges;
  for (const auto& [edge, at] : surfaces_at)
    if (at.contains(a) && at.contains(b)) edges.push_back(edge);
  return edges;
}

}  // namespace geomesh::geomodel::testing
