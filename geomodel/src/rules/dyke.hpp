// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Dykes and sills: makes a closed body from a sheet with a thickness.
#pragma once

#include "rules/extend/extend.hpp"

namespace geomesh::geomodel {

/// Turns a surface (the middle of a dyke or sill) into a closed body: two walls, each half of the thickness away along
/// the normals, and a rim between their borders. Existing points and triangles become the wall on the side of the
/// normals. They are followed by those of the other wall, then those of the rim. Each connected part is first given a
/// consistent orientation. Throws Error{invalid_input} with the triangle and the place if an edge has three triangles,
/// if the surface has only one side, or if it bends too sharply for a wall at a constant distance. Walls of different
/// parts may cross: the arrangement resolves that as for any body. O(n log n).
void thicken(TriangulatedSurface& sheet, double thickness, const BuildLog& log);

}  // namespace geomesh::geomodel
