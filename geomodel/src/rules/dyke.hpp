// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Dykes and sills: makes a closed body from a sheet with a thickness.
#pragma once

#include "rules/extend/extend.hpp"

namespace geomesh::geomodel {

/// Gives the sheet two walls, each half of the thickness away along its normals, and a rim between their borders.
///
/// Given points and triangles become the wall on the side of the normals. The rows of the other wall follow, then those
/// of the rim. Each sheet is first given a consistent orientation. Throws Error{invalid_input} if the input is not a
/// sheet: an edge has three triangles, or the surface has only one side. Throws it too if the sheet bends too sharply
/// for a wall at a constant distance. The message has the triangle and the place. Walls of different parts of a sheet
/// may cross: the arrangement resolves that as of any body. O(n log n).
void thicken(TriangulatedSurface& sheet, double thickness, const BuildLog& log);

}  // namespace geomesh::geomodel
