// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Constrained Delaunay triangulation of points and lines that may cross, with CGAL behind it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

struct LinedTriangulation {
  std::vector<Vec2> points;         ///< those given, and where lines cross (rounded)
  std::vector<Triangle> triangles;  ///< counter-clockwise, of the convex hull
  /// Per triangle, bit i: the side opposite to vertex i is part of a line.
  std::vector<std::uint8_t> lined_sides;
};

/// Near-linear but for crossings of lines. The order of the result depends on the input alone.
LinedTriangulation triangulate_lines(const std::vector<Vec2>& points, const std::vector<std::vector<Vec2>>& lines);

}  // namespace geomesh::geomodel
