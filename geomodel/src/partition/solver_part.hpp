// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A part of a mesh as solver files hold it.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "partition/mesh_parts.hpp"
#include "solver_mesh/solver_mesh.hpp"

namespace geomesh::geomodel {

/// Blocks, groups and names are those of the whole mesh in every part, so that numbers agree between files. Blocks have
/// the cells of the part alone, and may be empty.
struct SolverPart {
  MeshPart part;
  SolverMesh mesh;                               ///< nodes numbered in the part
  std::vector<std::vector<std::size_t>> cells;   ///< by block: which cells of the whole mesh's block are left
  std::vector<std::vector<std::int32_t>> owner;  ///< of these
};

/// Solids: all of the part. Faces: those at an element of the part, owned with the element that the normal points away
/// from (at the boundary, the only one). Edges and points: those whose nodes all belong to the part, owned with the
/// lowest owner of their nodes.
SolverPart part_of(const SolverMesh& whole, const MeshParts& parts, std::int32_t number, Ghosts ghosts);

/// Nodes of a group of the whole mesh that belong to the part, numbered in the part.
std::vector<VertexIndex> nodes_in_part(const std::vector<VertexIndex>& nodes_of_whole, const MeshPart& part);

}  // namespace geomesh::geomodel
