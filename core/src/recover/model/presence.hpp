// SPDX-License-Identifier: MIT
/// @file
/// Which declared constraints are in the mesh. Each subsegment, subfacet and piece remembers where it was seen last;
/// the mesh is looked at there before it is searched, so asking again costs next to nothing where nothing has changed.
/// A memory may be wrong at any time: it is compared with the mesh each time, and so changes no answer.
#pragma once

#include "recover/model/constrained_mesh.hpp"
#include "recover/model/constraints.hpp"
#include "recover/model/facet_trace.hpp"

namespace geomesh::recover {

/// A cell that has the subsegment, or no_cell where it is no edge. Both its ends are in the mesh.
CellIndex cell_of_subsegment(ConstrainedMesh& mesh, Constraints& constraints, Index subsegment);

/// The face of a subfacet that is no piece, from the cell above it, or an invalid reference where it is none. Its
/// vertices are in the mesh.
FaceRef face_of_subfacet(ConstrainedMesh& mesh, Constraints& constraints, Index subfacet);

/// As trace_facet, for a piece as it is declared; where the faces that covered it when it was seen last are all there,
/// it is not traced again.
FacetTrace trace_piece(ConstrainedMesh& mesh, Constraints& constraints, Index subfacet);

/// Per subsegment a cell that has it, or no_cell, by one pass over the cells. O(cells).
std::vector<CellIndex> cells_of_subsegments(const TetMesh& cells, const Constraints& constraints);

}  // namespace geomesh::recover
