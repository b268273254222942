// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Polygons in files of surfaces: triangulation and containment, decided exactly in the plane of two coordinate axes.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Projects a polygon to a coordinate plane by dropping the coordinate along which its area vector is largest. Its
/// orientation is kept, and nothing is rounded.
struct PlaneProjection {
  explicit PlaneProjection(std::span<const Vec3> polygon);
  Vec2 operator()(const Vec3& p) const { return {p[axis[0]], p[axis[1]]}; }
  std::size_t axis[2] = {0, 1};
};

/// Triangulates a polygon by ear clipping, with the first possible ear each time; the triangles keep the orientation of
/// the polygon. Returns an empty list if the polygon crosses itself in projection, or is degenerate. Quadratic in the
/// number of corners.
std::vector<Triangle> triangulate_polygon(std::span<const Vec3> points, std::span<const VertexIndex> loop);

/// Appends a polygon as triangles. A triangle is appended unchanged, even if it is degenerate. Returns false if the
/// polygon cannot be triangulated.
bool append_polygon(std::span<const Vec3> points, std::span<const VertexIndex> loop, std::vector<Triangle>& triangles);

/// Returns 1 for a point inside the polygon, 0 on its border, -1 outside.
int side_of_polygon(std::span<const Vec2> polygon, const Vec2& p);

}  // namespace geomesh::geomodel
