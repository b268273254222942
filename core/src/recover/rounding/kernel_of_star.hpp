// SPDX-License-Identifier: MIT
/// @file
/// The places that see all of a vertex' star: where it may be for all of its cells to be positive.
#pragma once

#include <optional>

#include "recover/model/constrained_mesh.hpp"
#include "recover/rounding/wide_polyhedron.hpp"

namespace geomesh::recover {

/// Of a star without ghosts whose cells are positive. Its lattice is that of the doubles with an ulp of the star's
/// largest coordinate. nothing: a coordinate is zero all over. O(cells).
std::optional<WidePolyhedron> kernel_of_star(const ConstrainedMesh& mesh, const std::vector<CellIndex>& star,
                                             VertexIndex x);

}  // namespace geomesh::recover
