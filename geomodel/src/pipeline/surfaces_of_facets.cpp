// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/surfaces_of_facets.hpp"

#include <algorithm>

namespace geomesh::geomodel {

std::string surfaces_of_facets(const std::vector<Index>& facets, const Arranged& arranged) {
  std::vector<Index> surfaces;
  const PiecewiseLinearComplex& plc = arranged.plc.plc;
  for (const Index f : facets)
    if (const Index set = plc.facet_provenance[f]; set != no_index)
      surfaces.insert(surfaces.end(), plc.provenance_sets[set].begin(), plc.provenance_sets[set].end());
  std::sort(surfaces.begin(), surfaces.end());
  surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
  std::string out;
  for (const Index s : surfaces) out += (out.empty() ? "" : ", ") + arranged.surfaces[s].name;
  return out;
}

}  // namespace geomesh::geomodel
