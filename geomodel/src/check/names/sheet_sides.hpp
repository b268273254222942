// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which side of a horizon is up: one answer for each connected sheet, by most of its area in the map.
#pragma once

#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel::checking {

/// The least cosine of the angle between a face and the triangle that it stands for, for which the face shows a side of
/// it. Below it, rounding and the tolerance decide which side that is: where a horizon ends on a fault within the
/// tolerance, faces of the fault bear it, too.
inline constexpr double least_cosine = 0.1;

/// Per triangle: +1 where the normal as stored points to the upper side of its sheet, else -1. Sheets are joined across
/// edges with just two triangles. A sheet that cannot be oriented is judged triangle by triangle.
std::vector<int> upper_sides(const TriangulatedSurface& surface);

}  // namespace geomesh::geomodel::checking
