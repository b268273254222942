// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Merges points with equal coordinates.
#pragma once

#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Returns for each point the index of the first point with equal coordinates. O(n log n).
std::vector<VertexIndex> merge_equal_points(const std::vector<Vec3>& points);

/// Returns the triangles of the surface with equal points replaced by the first of them. If two corners of a triangle
/// become equal, its neighbours across the other two edges meet directly. Then all three corners are set to the same
/// point, so that the triangle has no edge between different points. O(n log n).
std::vector<Triangle> merged_triangles(const TriangulatedSurface& surface);
/// Merges equal points of triangles in linear time; `merged` is the result of merge_equal_points for the points.
std::vector<Triangle> merged_triangles(const TriangulatedSurface& surface, const std::vector<VertexIndex>& merged);

}  // namespace geomesh::geomodel
