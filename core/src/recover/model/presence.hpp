// SPDX-License-Identifier: MIT
/// @file
/// Determines which declared constraints are in the mesh. Each subsegment, subfacet and piece stores where it was found
/// last; that place is examined before the mesh is searched, so repeated queries are cheap if nothing has changed. A
/// stored place may be outdated: it is compared with the mesh each time, so results never depend on it.
#pragma once

#include "recover/model/constrained_mesh.hpp"
#include "recover/model/constraints.hpp"
#include "recover/model/facet_trace.hpp"

namespace geomesh::recover {

/// Returns a cell that contains the subsegment, or no_cell if it is not an edge. Both its ends must be in the mesh.
CellIndex cell_of_subsegment(ConstrainedMesh& mesh, Constraints& constraints, Index subsegment);

/// Returns the face of a subfacet that is not a piece, from the cell above it, or an invalid reference if there is
/// none. Its vertices must be in the mesh.
FaceRef face_of_subfacet(ConstrainedMesh& mesh, Constraints& constraints, Index subfacet);

/// Like trace_facet, for a declared piece; if the faces that covered it last still exist, it is not traced again.
FacetTrace trace_piece(ConstrainedMesh& mesh, Constraints& constraints, Index subfacet);

/// Returns for each subsegment a cell that contains it, or no_cell, in one pass over the cells. O(cells).
std::vector<CellIndex> cells_of_subsegments(const TetMesh& cells, const Constraints& constraints);

}  // namespace geomesh::recover
