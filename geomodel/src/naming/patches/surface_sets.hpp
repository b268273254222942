// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The surface sets of the facets of a polygon soup.
#pragma once

#include <vector>

#include "geomesh/geomodel/arrangement.hpp"

namespace geomesh::geomodel {

/// The different sets of surfaces that facets stand for, in the order of their first facet; each ascending.
struct SurfaceSets {
  std::vector<std::vector<Index>> sets;
  std::vector<Index> of_facet;  ///< row in `sets`
};
SurfaceSets surface_sets(const PolygonSoup& soup);

}  // namespace geomesh::geomodel
