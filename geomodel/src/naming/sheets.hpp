// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Orientation of surfaces as read: closed or not, and which side of an open sheet is up.
#pragma once

#include <cstdint>
#include <vector>

#include "common/equal_points.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// True where every edge (equal coordinates merged) is run through as often in one direction as in the other: then
/// winding numbers are defined for every point off the surface. An empty surface is not closed.
bool is_closed(const TriangulatedSurface& surface);

/// Which triangles have their upper side where their stored normal points. Triangles joined through edges of exactly
/// two triangles form a sheet; a sheet is oriented as one, so that overturned folds keep their sides. Up is where most
/// of its area, seen from above and with sign, says so. Where a sheet cannot be oriented (a Moebius band) each of its
/// triangles speaks for itself.
struct UpwardSides {
  std::vector<std::uint8_t> as_stored;  ///< per triangle
  std::size_t n_unorientable_sheets = 0;
};
UpwardSides orient_upward(const TriangulatedSurface& surface);

}  // namespace geomesh::geomodel
