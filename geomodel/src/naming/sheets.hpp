// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Orientation of surfaces as read: whether they are closed, and which side of an open sheet is up.
#pragma once

#include <cstdint>
#include <vector>

#include "common/equal_points.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Returns true if every edge (equal coordinates merged) is traversed as often in one direction as in the other, so
/// that winding numbers are defined for every point off the surface. An empty surface is not closed.
bool is_closed(const TriangulatedSurface& surface);

/// For each triangle, whether its stored normal points to the upper side. Triangles joined through edges of
/// exactly two triangles form a sheet; a sheet is oriented as one, so that overturned folds keep their sides. The upper
/// side is the one that has the larger horizontal projection of its signed area. If a sheet cannot be oriented (a
/// Moebius band), each of its triangles is decided separately.
struct UpwardSides {
  std::vector<std::uint8_t> as_stored;  ///< per triangle
  std::size_t n_unorientable_sheets = 0;
};
UpwardSides orient_upward(const TriangulatedSurface& surface);

}  // namespace geomesh::geomodel
