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
  /// For each block of the whole mesh, the rows in it of the cells that the part has.
  std::vector<std::vector<std::size_t>> cells;
  std::vector<std::vector<std::int32_t>> owner;  ///< of these
};

/// Makes the part of a mesh for solver files. It has all solids of the part. It has the faces of these solids; the
/// owner of a face is that of the solid from which the normal points away (at the boundary, the only one). It has the
/// edges and points whose nodes all belong to the part; their owner is the lowest owner of their nodes.
SolverPart part_of(const SolverMesh& whole, const MeshParts& parts, std::int32_t number, Ghosts ghosts);

/// Returns those nodes of a group of the whole mesh that belong to the part, as numbered in the part.
std::vector<VertexIndex> nodes_in_part(const std::vector<VertexIndex>& nodes_of_whole, const MeshPart& part);

}  // namespace geomesh::geomodel
