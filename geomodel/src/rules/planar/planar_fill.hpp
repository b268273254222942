// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Constrained Delaunay triangulation of points in a plane, implemented with CGAL.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

struct PlanarTriangle {
  std::array<Index, 3> vertices;  ///< indices of the triangle's corners, counter-clockwise
  int depth;  ///< least number of constraints between the triangle and the outside: 1 inside a loop, 2 in a hole
};

/// Triangulates points with constraints. Returns all triangles of the points' convex hull; their order depends on the
/// input alone. Returns nothing if constraints cross each other or pass through a point, or if two points are equal.
std::optional<std::vector<PlanarTriangle>> triangulate_plane(const std::vector<Vec2>& points,
                                                             const std::vector<std::pair<Index, Index>>& constraints);

}  // namespace geomesh::geomodel
