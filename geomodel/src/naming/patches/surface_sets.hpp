// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The sets of surfaces to which the facets of a polygon soup belong.
#pragma once

#include <vector>

#include "geomesh/geomodel/arrangement.hpp"

namespace geomesh::geomodel {

/// The distinct sets of surfaces to which facets belong, in the order of their first facet; each set is ascending.
struct SurfaceSets {
  std::vector<std::vector<Index>> sets;
  std::vector<Index> of_facet;  ///< row in `sets`
};
SurfaceSets surface_sets(const PolygonSoup& soup);

}  // namespace geomesh::geomodel
