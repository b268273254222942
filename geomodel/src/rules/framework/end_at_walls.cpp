// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/framework/end_at_walls.hpp"

#include <algorithm>

#include "arrangement/clip/cut_off_parts.hpp"

namespace geomesh::geomodel {

std::span<const Index> part_of(const BuiltRows& built, Index row) {
  return row < built.part_of_triangle.size() ? std::span<const Index>(built.part_of_triangle[row])
                                             : std::span<const Index>();
}

double end_at_walls(WorkingSoup& working, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                    Index row) {
  const auto origins_of = [&](Index f) { return std::span<const PolygonSoup::Origin>(working.origins[f]); };
  const auto cut_off =
      arrangement::parts_cut_off({working.soup.facets, working.uses, origins_of},
                                 {surfaces[row], row, built.part_of_triangle[row], built.continued_to[row], {}});
  double removed = 0;
  for (const auto& [facet, triangle] : cut_off)
    removed += working.remove(
        {facet}, [&, t = triangle](const PolygonSoup::Origin& o) { return o.surface == row && o.triangle == t; });
  return removed;
}

}  // namespace geomesh::geomodel
