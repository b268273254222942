// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Constrained Delaunay triangulation of points and lines that may cross, implemented with CGAL.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

struct LinedTriangulation {
  std::vector<Vec2> points;  ///< the input points, those of the lines, and the (rounded) points where lines cross
  std::vector<Triangle> triangles;  ///< counter-clockwise triangles of the points' convex hull
  /// For each triangle, bit i is set if the side opposite vertex i is part of a constraint line.
  std::vector<std::uint8_t> lined_sides;
};

/// Triangulates points and lines, in an order that depends on the input alone. Nearly linear except for crossings.
LinedTriangulation triangulate_lines(const std::vector<Vec2>& points, const std::vector<std::vector<Vec2>>& lines);

}  // namespace geomesh::geomodel
