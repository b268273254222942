// SPDX-License-Identifier: MIT
/// @file
/// The kernel of a vertex' star: the places of the vertex from which all opposite faces are visible, so that all cells
/// of the star are positive.
#pragma once

#include <optional>

#include "recover/model/constrained_mesh.hpp"
#include "recover/rounding/wide_polyhedron.hpp"

namespace geomesh::recover {

/// Returns the kernel of the star of x, whose cells are positive and no ghosts. The spacing of its lattice along an
/// axis is an ulp of the star's largest coordinate on the axis. Returns nothing if all of these are zero. O(cells).
std::optional<WidePolyhedron> kernel_of_star(const ConstrainedMesh& mesh, const std::vector<CellIndex>& star,
                                             VertexIndex x);

}  // namespace geomesh::recover
