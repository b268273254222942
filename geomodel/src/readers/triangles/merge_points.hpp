// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Merges points with equal coordinates.
#pragma once

#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Appends the distinct points to `merged` (empty on entry) in the order of their first occurrence; returns the row of
/// each. Equal means equal coordinates (-0 equals 0). Expected linear time.
std::vector<VertexIndex> merge_equal_points(const std::vector<Vec3>& points, std::vector<Vec3>& merged);

}  // namespace geomesh::geomodel
