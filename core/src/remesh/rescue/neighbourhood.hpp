// SPDX-License-Identifier: MIT
/// @file
/// What is about a cell: cells, vertices that may move, edges that may be contracted.
#pragma once

#include <array>
#include <vector>

#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

Vec3 centroid(const DomainMesh& mesh, CellIndex c);

/// Cells with at least two vertices of the cell, it among them. Ascending.
std::vector<CellIndex> cells_about(Toolbox& tools, const Tetrahedron& t);

/// The cell's vertices and their neighbours that may move. Ascending.
std::vector<VertexIndex> movable_about(Toolbox& tools, const Tetrahedron& t);

/// The nearest vertex that shares an edge with u; of equally near ones the lowest.
VertexIndex nearest_neighbour(Toolbox& tools, VertexIndex u);

/// Pairs (u, v): each movable vertex of the cell, and of the cells about it, with each of the cell's vertices or its
/// nearest neighbour.
std::vector<std::array<VertexIndex, 2>> edges_to_collapse(Toolbox& tools, const Tetrahedron& t);

}  // namespace geomesh::remesh
