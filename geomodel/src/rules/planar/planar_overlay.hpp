// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One triangulation of the map that contains the edges of several surfaces, implemented with CGAL.
#pragma once

#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

struct PlanarOverlay {
  /// Points of the surfaces, and the (rounded) points where their edges cross in the map.
  std::vector<Vec2> points;
  std::vector<Triangle> triangles;  ///< counter-clockwise triangles of the points' whole convex hull
};
/// Overlays the edges of all surfaces in the map. Nearly linear except for the crossings of edges.
PlanarOverlay overlay_in_map(const std::vector<const TriangulatedSurface*>& surfaces);

}  // namespace geomesh::geomodel
