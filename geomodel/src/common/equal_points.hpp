// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Merges points with equal coordinates.
#pragma once

#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Returns for each point the row of the first point with equal coordinates. O(n log n).
std::vector<VertexIndex> merge_equal_points(const std::vector<Vec3>& points);

/// Returns each triangle of the surface with equal points replaced by the first of them. If two corners of a triangle
/// are equal, its neighbours across the other two edges meet there: all three corners are then set to the same point,
/// so that it has no edge with two ends and nothing ends at it. O(n log n).
std::vector<Triangle> merged_triangles(const TriangulatedSurface& surface);
/// Does the same in linear time; `merged` is the result of merge_equal_points for the surface's points.
std::vector<Triangle> merged_triangles(const TriangulatedSurface& surface, const std::vector<VertexIndex>& merged);

}  // namespace geomesh::geomodel
