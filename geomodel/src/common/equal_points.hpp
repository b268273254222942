// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Points with equal coordinates.
#pragma once

#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Rows of the first point with equal coordinates, per point. O(n log n).
std::vector<VertexIndex> merge_equal_points(const std::vector<Vec3>& points);

}  // namespace geomesh::geomodel
