// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Polygons of files: triangulation and containment, decided exactly in the plane of two of the axes.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Drops the coordinate along which the polygon's area vector is largest (exact, as nothing is computed), keeping its
/// orientation.
struct PlaneProjection {
  explicit PlaneProjection(std::span<const Vec3> polygon);
  Vec2 operator()(const Vec3& p) const { return {p[axis[0]], p[axis[1]]}; }
  std::size_t axis[2] = {0, 1};
};

/// Triangulates by ear clipping, using the first ear in the order of the loop each time; the triangles keep the loop's
/// orientation. Returns an empty list if the polygon crosses itself in projection, or is degenerate. Quadratic in the
/// polygon's size.
std::vector<Triangle> triangulate_polygon(std::span<const Vec3> points, std::span<const VertexIndex> loop);

/// Appends the polygon as triangles. A triangle is appended unchanged, degenerate or not. Returns false if the polygon
/// cannot be triangulated.
bool append_polygon(std::span<const Vec3> points, std::span<const VertexIndex> loop, std::vector<Triangle>& triangles);

/// Returns 1 inside, 0 on the border, -1 outside.
int side_of_polygon(std::span<const Vec2> polygon, const Vec2& p);

}  // namespace geomesh::geomodel
