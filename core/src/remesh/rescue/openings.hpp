// SPDX-License-Identifier: MIT
/// @file
/// Changes around a bad cell that may make the place worse, as the first step of a sequence of repair.
#pragma once

#include "common/random.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

/// Limit on the flatness of cells that an opening may leave. It is far below that of bad cells, which could not be
/// opened otherwise.
inline constexpr double opening_shape = 1e-7;

/// Makes one change around the live cell c, of a chosen kind and at a chosen place: removes a vertex (curves and
/// surfaces keep theirs), splits an edge, removes an edge or a face, puts a point into a cell or onto a face; mostly in
/// the cell or in one that shares an edge with it. Returns whether something changed.
bool open_about_cell(Toolbox& tools, CellIndex c, Random& choose);

/// Returns the cell's vertices and their neighbours that may move, in ascending order.
std::vector<VertexIndex> movable_about(Toolbox& tools, const Tetrahedron& t);

/// Returns the nearest vertex that shares an edge with u; among equally near ones the lowest.
VertexIndex nearest_neighbour(Toolbox& tools, VertexIndex u);

/// Removes as many points inside around the vertices of a cell as possible, each into its nearest neighbour. Earlier
/// repairs may have crowded them.
bool clear_about(Toolbox& tools, const Tetrahedron& t);

}  // namespace geomesh::remesh
