// SPDX-License-Identifier: MIT
/// @file
/// Determines which declared constraints are in the mesh. Each subsegment, subfacet and piece stores the cell in which
/// it was last found. This cell is examined before the mesh is searched, so repeated queries are cheap if nothing has
/// changed. Stored cells may be outdated; they are compared with the mesh each time, so results never depend on them.
#pragma once

#include "recover/model/constrained_mesh.hpp"
#include "recover/model/constraints.hpp"
#include "recover/model/facet_trace.hpp"

namespace geomesh::recover {

/// Returns a cell that contains the subsegment, or no_cell if it is not an edge. Both its ends must be in the mesh.
CellIndex cell_of_subsegment(ConstrainedMesh& mesh, Constraints& constraints, Index subsegment);

/// Returns the face of a subfacet that is not a piece, seen from the cell above it, or an invalid reference if the mesh
/// has no such face. The vertices of the subfacet must be in the mesh.
FaceRef face_of_subfacet(ConstrainedMesh& mesh, Constraints& constraints, Index subfacet);

/// Finds the mesh faces that cover a piece of a facet, and the mesh edges that pierce it. If the faces that were found
/// to cover it earlier still exist, these are returned without a search.
FacetTrace trace_piece(ConstrainedMesh& mesh, Constraints& constraints, Index subfacet);

/// Returns for each subsegment a cell that contains it, or no_cell, in one pass over the cells. O(cells).
std::vector<CellIndex> cells_of_subsegments(const TetMesh& cells, const Constraints& constraints);

}  // namespace geomesh::recover
