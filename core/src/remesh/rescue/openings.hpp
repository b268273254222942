// SPDX-License-Identifier: MIT
/// @file
/// Changes about a bad cell that may make the place worse: what sequences of repair open with.
#pragma once

#include "common/random.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

/// No flatter cell may an opening leave: far flatter than bad ones may be, else those themselves could not be opened.
inline constexpr double opening_shape = 1e-7;

/// One change about the live cell c, of a kind and at a place that are chosen: a vertex removed (curves and surfaces
/// keep theirs), an edge split; an edge or a face removed; a point put into a cell or onto a face; in the cell or in
/// one that shares an edge with it, mostly. Returns whether something changed.
bool open_about_cell(Toolbox& tools, CellIndex c, Random& choose);

/// The cell's vertices and their neighbours that may move. Ascending.
std::vector<VertexIndex> movable_about(Toolbox& tools, const Tetrahedron& t);

/// The nearest vertex that shares an edge with u; of equally near ones the lowest.
VertexIndex nearest_neighbour(Toolbox& tools, VertexIndex u);

/// Removes the points inside about the vertices of a cell, as many as go, each into its nearest neighbour: where
/// earlier repairs have crowded them.
bool clear_about(Toolbox& tools, const Tetrahedron& t);

}  // namespace geomesh::remesh
