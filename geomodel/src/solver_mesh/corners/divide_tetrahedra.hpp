// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Tetrahedra of a mesh that has no names yet, divided about their centres.
#pragma once

#include <cstddef>
#include <vector>

#include "geomesh/core/tetrahedralize.hpp"

namespace geomesh::geomodel {

/// Divides each of these tetrahedra (rows) into four about its centre. Row i keeps one part, the others follow all
/// rows. Components, faces and their tetrahedra on both sides stay right; points are added inside. Throws
/// Error{cannot_mesh} with the place where one is too flat for a centre in doubles. O(tetrahedra) where there is
/// anything to divide.
void divide_tetrahedra(ConstrainedTetrahedralization& mesh, const std::vector<std::size_t>& rows);

/// The centre of a tetrahedron. Throws Error{cannot_mesh} with the place where one of the four parts about it, in which
/// the centre stands in for one corner, would not be positive: decided exactly.
Vec3 centre_that_divides(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace geomesh::geomodel
