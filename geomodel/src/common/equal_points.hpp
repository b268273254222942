// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Points with equal coordinates.
#pragma once

#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Rows of the first point with equal coordinates, per point. O(n log n).
std::vector<VertexIndex> merge_equal_points(const std::vector<Vec3>& points);

/// Each triangle of the surface over the first of equal points. Where two corners of a triangle are equal, its
/// neighbours across the other two edges meet there: all three are then the same point, so that it has no edge of two
/// ends and nothing ends at it. O(n log n).
std::vector<Triangle> merged_triangles(const TriangulatedSurface& surface);
/// Does the same in linear time; `merged` is what merge_equal_points gives for the surface's points.
std::vector<Triangle> merged_triangles(const TriangulatedSurface& surface, const std::vector<VertexIndex>& merged);

}  // namespace geomesh::geomodel
