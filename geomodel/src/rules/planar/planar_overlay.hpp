// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One triangulation of the map that holds the edges of several surfaces, with CGAL behind it.
#pragma once

#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

struct PlanarOverlay {
  std::vector<Vec2> points;         ///< those of the surfaces, and where their edges cross in the map (rounded)
  std::vector<Triangle> triangles;  ///< counter-clockwise, of the whole convex hull
};
/// Near-linear but for the crossings of edges.
PlanarOverlay overlay_in_map(const std::vector<const TriangulatedSurface*>& surfaces);

}  // namespace geomesh::geomodel
