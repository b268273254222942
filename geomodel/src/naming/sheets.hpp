// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines whether input surfaces are closed, and which side of an open surface is up.
#pragma once

#include <cstdint>
#include <vector>

#include "common/equal_points.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Returns true if every edge of the surface (equal coordinates merged) is traversed as often in one direction as in
/// the other, so that winding numbers are defined for every point off the surface. An empty surface is not closed.
bool is_closed(const TriangulatedSurface& surface);

/// Stores for each triangle whether its normal points to the upper side of its surface. Triangles joined through edges
/// of exactly two triangles form a sheet; a sheet is oriented as a whole, so that overturned folds keep their sides.
/// Its upper side is the one with the larger area when projected to the map. If a sheet cannot be oriented (a Moebius
/// band), each of its triangles is decided separately.
struct UpwardSides {
  std::vector<std::uint8_t> as_stored;  ///< per triangle
  std::size_t n_unorientable_sheets = 0;
};
UpwardSides orient_upward(const TriangulatedSurface& surface);

}  // namespace geomesh::geomodel
