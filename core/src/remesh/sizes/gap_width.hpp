// SPDX-License-Identifier: MIT
/// @file
/// How far a face of a surface is from the surface that it faces.
#pragma once

#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

/// Distance from `origin` along the face's normal into c to the next constrained face that faces back. `origin` is a
/// point of the constrained face i of cell c. Infinite where that face stands at more than 60 degrees to this one or
/// shares a vertex with it (a corner, not a gap). Infinite too where 500 cells do not reach one.
double gap_width(const DomainMesh& mesh, CellIndex c, unsigned i, const Vec3& origin);

}  // namespace geomesh::remesh
