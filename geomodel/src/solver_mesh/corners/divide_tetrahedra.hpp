// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Divides tetrahedra around their centres, in a mesh whose regions and surfaces have no names yet.
#pragma once

#include <cstddef>
#include <vector>

#include "geomesh/core/tetrahedralize.hpp"

namespace geomesh::geomodel {

/// Divides the tetrahedra in `rows` into four around their centres. Row i keeps one of the four, and the others are
/// appended. Mesh components, faces and the tetrahedra on both sides of faces are updated; the centres are added as
/// inner points. Throws Error{cannot_mesh} with the place if a tetrahedron is too flat for a centre in doubles.
/// O(tetrahedra) if there is anything to divide.
void divide_tetrahedra(ConstrainedTetrahedralization& mesh, const std::vector<std::size_t>& rows);

/// Returns the centre of a tetrahedron. Throws Error{cannot_mesh} with the place if one of the four parts around it, in
/// which the centre replaces one corner, would not be positive; this is decided exactly.
Vec3 centre_that_divides(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace geomesh::geomodel
