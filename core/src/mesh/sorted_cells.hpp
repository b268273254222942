// SPDX-License-Identifier: MIT
/// @file
/// A mesh laid out in memory by what it is, not by how it was made.
#pragma once

#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// The same mesh of vertices below `n_vertices`, cells ascending by their vertices. Each cell begins at its least
/// vertex, goes on with the least of the others and keeps its orientation. Ghosts too; flags are zero, no slot is free.
/// So whatever walks over it does the same whichever way, and in whichever order, the points were inserted. O(n) for
/// bounded degrees.
TetMesh with_sorted_cells(const TetMesh& mesh, VertexIndex n_vertices);

}  // namespace geomesh
