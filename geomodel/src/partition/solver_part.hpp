// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Makes a part of a mesh in the form in which solver files are written.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "partition/mesh_parts.hpp"
#include "solver_mesh/solver_mesh.hpp"

namespace geomesh::geomodel {

/// A part of a mesh for solver files. Blocks of cells, groups and names are those of the whole mesh in every part, so
/// that numbers agree between files. Blocks contain only the cells of the part, and may be empty.
struct SolverPart {
  MeshPart part;
  SolverMesh mesh;  ///< the mesh of the part, with nodes numbered in the part
  /// For each block of cells of the whole mesh: the rows, within the block, of the cells that this part has.
  std::vector<std::vector<std::size_t>> cells;
  std::vector<std::vector<std::int32_t>> owner;  ///< of these
};

/// Makes the part of a mesh for solver files. It has all solids (volume cells) of the part and their faces; the owner
/// of a face is that of the solid from which the normal points away (at the boundary, the only one). It has the edges
/// and points whose nodes all belong to the part; their owner is the lowest owner of their nodes.
SolverPart part_of(const SolverMesh& whole, const MeshParts& parts, std::int32_t number, Ghosts ghosts);

/// Returns those nodes of a node set of the whole mesh that a mesh part has, by their numbers in the part.
std::vector<VertexIndex> nodes_in_part(const std::vector<VertexIndex>& nodes_of_whole, const MeshPart& part);

}  // namespace geomesh::geomodel
