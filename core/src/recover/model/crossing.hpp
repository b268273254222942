// SPDX-License-Identifier: MIT
/// @file
/// Finds the simplex through which the straight line from a vertex towards a missing neighbour first leaves the star of
/// that vertex, with exact predicates.
#pragma once

#include "recover/model/constrained_mesh.hpp"

namespace geomesh::recover {

enum class CrossingKind {
  edge_present,  ///< the start and the end of the line are connected by a mesh edge
  vertex,        ///< the line runs through the vertex v[0], strictly between its ends
  edge,          ///< the line crosses the mesh edge v[0]-v[1] between its ends
  face,          ///< the line crosses the interior of `face` = v[0] v[1] v[2]
};

struct Crossing {
  CrossingKind kind = CrossingKind::edge_present;
  CellIndex cell = no_cell;  ///< a cell that has the vertex at the line's start and the mesh item that it crosses
  FaceRef face;              ///< the face of `cell` opposite the vertex at which the line starts
  std::array<VertexIndex, 3> v{no_vertex, no_vertex, no_vertex};
};

/// Returns the first simplex that the line from a to b crosses. Both vertices must be in the mesh. O(degree of a).
Crossing first_crossing(ConstrainedMesh& mesh, VertexIndex a, VertexIndex b);

/// The mesh edges and faces that the line from a to b crosses, in order, and the cells at them, to be replaced.
struct LineCrossings {
  std::vector<Crossing> crossings;  ///< edges and faces
  std::vector<CellIndex> cells;     ///< cells that the line passes through, and all cells around edges that it crosses
};

/// Finds all crossings of the line from a to b. Returns false if the line runs through a vertex or meets a ghost; `out`
/// then has the crossings before that. Both vertices must be in the mesh and not connected. O(cells crossed).
bool walk_line(ConstrainedMesh& mesh, VertexIndex a, VertexIndex b, LineCrossings& out);

}  // namespace geomesh::recover
