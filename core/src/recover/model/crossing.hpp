// SPDX-License-Identifier: MIT
/// @file
/// Finds the simplex through which the straight line from a vertex towards a missing neighbour first leaves the star of
/// that vertex, with exact predicates.
#pragma once

#include "recover/model/constrained_mesh.hpp"

namespace geomesh::recover {

enum class CrossingKind {
  edge_present,  ///< the two vertices are connected by an edge
  vertex,        ///< the line runs through `v[0]`, which lies strictly between the two vertices
  edge,          ///< the line crosses the mesh edge v[0]-v[1] between its ends
  face,          ///< the line crosses the interior of `face` = v[0] v[1] v[2]
};

struct Crossing {
  CrossingKind kind = CrossingKind::edge_present;
  CellIndex cell = no_cell;  ///< a cell that has the line's start and the mesh face or edge that the line crosses
  FaceRef face;              ///< the face of `cell` opposite the start of the line
  std::array<VertexIndex, 3> v{no_vertex, no_vertex, no_vertex};
};

/// Returns the first simplex that the line from a to b crosses. Both vertices must be in the mesh. O(degree of a).
Crossing first_crossing(ConstrainedMesh& mesh, VertexIndex a, VertexIndex b);

/// The mesh edges and faces that the line from a to b crosses, in order, and the cells at them, to be replaced.
struct LineCrossings {
  std::vector<Crossing> crossings;  ///< edges and faces
  std::vector<CellIndex> cells;     ///< cells through which the line runs, and all cells around crossed edges
};

/// Finds all crossings of the line from a to b. Returns false if the line runs through a vertex or meets a ghost; `out`
/// then has the crossings before that. Both vertices must be in the mesh and not connected. O(cells crossed).
bool walk_line(ConstrainedMesh& mesh, VertexIndex a, VertexIndex b, LineCrossings& out);

}  // namespace geomesh::recover
