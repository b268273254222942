// SPDX-License-Identifier: MIT
/// @file
/// A memory layout of a mesh that depends on its cells alone, not on how they were made.
#pragma once

#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// Returns the same mesh with its cells, including ghosts, sorted by their vertices, which are below `n_vertices`. Each
/// cell begins with its least vertex, followed by the least of the others, and keeps its orientation. Flags are zero,
/// and no slot is free. Algorithms that traverse the mesh therefore give the same result for every order and algorithm
/// of insertion. O(n) for bounded degrees.
TetMesh with_sorted_cells(const TetMesh& mesh, VertexIndex n_vertices);

}  // namespace geomesh
