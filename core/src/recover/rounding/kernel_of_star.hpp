// SPDX-License-Identifier: MIT
/// @file
/// The kernel of a vertex' star: the places from which all of its faces are visible, so that all of its cells are
/// positive.
#pragma once

#include <optional>

#include "recover/model/constrained_mesh.hpp"
#include "recover/rounding/wide_polyhedron.hpp"

namespace geomesh::recover {

/// Returns the kernel of a star without ghosts whose cells are positive. Its lattice is that of the doubles with an ulp
/// of the star's largest coordinate. Returns nothing if a coordinate is zero everywhere. O(cells).
std::optional<WidePolyhedron> kernel_of_star(const ConstrainedMesh& mesh, const std::vector<CellIndex>& star,
                                             VertexIndex x);

}  // namespace geomesh::recover
