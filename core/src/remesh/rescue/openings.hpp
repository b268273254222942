// SPDX-License-Identifier: MIT
/// @file
/// Openings: random changes around a bad cell that may worsen the shapes there, as first steps of sequences of repair.
#pragma once

#include "common/random.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

/// Least shape of cells that an opening may leave. It is far below that of bad cells, to which openings are applied.
inline constexpr double opening_shape = 1e-7;

/// Makes one random change at a random place around the live cell c: removes a vertex that is no corner, splits an
/// edge, removes an edge or a face, inserts a point into a cell or on a face. Mostly the change is in the cell itself
/// or in one that shares an edge with it. Returns whether something changed.
bool open_about_cell(Toolbox& tools, CellIndex c, Random& choose);

/// Returns the cell's vertices and their neighbours that may move, in ascending order.
std::vector<VertexIndex> movable_about(Toolbox& tools, const Tetrahedron& t);

/// Returns the nearest vertex that shares an edge with u; of equally near ones the one with the lowest index.
VertexIndex nearest_neighbour(Toolbox& tools, VertexIndex u);

/// Removes as many inner points around the vertices of a cell as possible, by contracting each into its nearest
/// neighbour. Earlier repairs may have crowded these points.
bool clear_about(Toolbox& tools, const Tetrahedron& t);

}  // namespace geomesh::remesh
