// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines which side of a horizon is up: one answer for each connected part, from most of its area in the map.
#pragma once

#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel::checking {

/// Least cosine of the angle between a face and its input triangle for which the face determines the side of the
/// horizon. Below this value, the side depends on rounding and the tolerance: where a horizon ends on a fault within
/// the tolerance, faces of the fault also belong to the horizon.
inline constexpr double least_cosine = 0.1;

/// For each triangle, returns +1 if its stored normal points to the upper side of the horizon, else -1. Triangles are
/// joined to connected parts across edges with exactly two triangles. In a non-orientable part each triangle is decided
/// alone.
std::vector<int> upper_sides(const TriangulatedSurface& surface);

}  // namespace geomesh::geomodel::checking
