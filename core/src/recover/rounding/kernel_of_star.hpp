// SPDX-License-Identifier: MIT
/// @file
/// The kernel of a vertex' star: the places of the vertex from which all opposite faces are visible, so that all cells
/// of the star are positive.
#pragma once

#include <optional>

#include "recover/model/constrained_mesh.hpp"
#include "recover/rounding/wide_polyhedron.hpp"

namespace geomesh::recover {

/// Returns the kernel of a star without ghosts whose cells are positive. The spacing of its lattice is an ulp of the
/// star's largest coordinate along each axis. Returns nothing if a coordinate is zero everywhere. O(cells).
std::optional<WidePolyhedron> kernel_of_star(const ConstrainedMesh& mesh, const std::vector<CellIndex>& star,
                                             VertexIndex x);

}  // namespace geomesh::recover
