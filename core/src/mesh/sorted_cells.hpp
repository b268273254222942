// SPDX-License-Identifier: MIT
/// @file
/// A memory layout of a mesh that depends on its cells alone, not on how they were made.
#pragma once

#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// Returns an equal mesh of vertices below `n_vertices` whose cells ascend by their vertices. Each cell begins with its
/// least vertex, followed by the least of the others, and keeps its orientation. That includes ghosts; flags are zero,
/// and no slot is free. So algorithms that traverse the mesh give the same result for every order and algorithm of
/// insertion. O(n) for bounded degrees.
TetMesh with_sorted_cells(const TetMesh& mesh, VertexIndex n_vertices);

}  // namespace geomesh
