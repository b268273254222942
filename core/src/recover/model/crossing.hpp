// SPDX-License-Identifier: MIT
/// @file
/// Where the straight line from a vertex towards a missing neighbour first leaves the star of that vertex. Exact.
#pragma once

#include "recover/model/constrained_mesh.hpp"

namespace geomesh::recover {

enum class CrossingKind {
  edge_present,  ///< the two are joined
  vertex,        ///< the line runs through `v[0]`, which lies strictly between them
  edge,          ///< the line crosses the inside of edge v[0]-v[1]
  face,          ///< the line crosses the inside of `face` = v[0] v[1] v[2]
};

struct Crossing {
  CrossingKind kind = CrossingKind::edge_present;
  CellIndex cell = no_cell;  ///< a cell with the start and the simplex crossed
  FaceRef face;              ///< of `cell`, opposite the start
  std::array<VertexIndex, 3> v{no_vertex, no_vertex, no_vertex};
};

/// Both in the mesh. O(degree of a).
Crossing first_crossing(ConstrainedMesh& mesh, VertexIndex a, VertexIndex b);

/// What the line from a to b crosses, in order, and what has to go for a-b to be an edge.
struct LineCrossings {
  std::vector<Crossing> crossings;  ///< edges and faces
  std::vector<CellIndex> cells;     ///< cells whose inside the line meets, and all cells about each edge crossed
};

/// False where the line runs through a vertex or meets a ghost; what was found before that is in `out`. Both in the
/// mesh and not joined. O(cells crossed).
bool walk_line(ConstrainedMesh& mesh, VertexIndex a, VertexIndex b, LineCrossings& out);

}  // namespace geomesh::recover
