// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Dykes and sills: a sheet with a thickness becomes a closed body.
#pragma once

#include "rules/extend/extend.hpp"

namespace geomesh::geomodel {

/// Gives the sheet two walls, each half of the thickness away along its normals, and a rim between their borders.
///
/// Rows of points and triangles as given become the wall on the side of the normals. The rows of the other wall follow,
/// then those of the rim. Sheets are oriented as one first. Throws Error{invalid_input} where the input is
/// no sheet: an edge has three triangles, or there is one side alone. Throws it too where the sheet bends too sharply
/// for a wall at a constant distance. The message has the triangle and the place. Walls of different parts of a sheet
/// may cross: the arrangement resolves that as of any body. O(n log n).
void thicken(TriangulatedSurface& sheet, double thickness, const BuildLog& log);

}  // namespace geomesh::geomodel
