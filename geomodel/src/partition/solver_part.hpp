// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A part of a mesh in the form needed by solver files.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "partition/mesh_parts.hpp"
#include "solver_mesh/solver_mesh.hpp"

namespace geomesh::geomodel {

/// Blocks, groups and names are those of the whole mesh in every part, so that numbers agree between files. Blocks
/// contain only the cells of the part, and may be empty.
struct SolverPart {
  MeshPart part;
  SolverMesh mesh;  ///< the part's mesh with nodes numbered in the part
  /// For each block: which cells of the whole mesh's block are in the part.
  std::vector<std::vector<std::size_t>> cells;
  std::vector<std::vector<std::int32_t>> owner;  ///< of these
};

/// Solids: all of the part. Faces: those at an element of the part, owned together with the element that the
/// normal points away from (at the boundary, the only one). Edges and points: those whose nodes all belong to the part,
/// owned by the lowest owner of their nodes.
SolverPart part_of(const SolverMesh& whole, const MeshParts& parts, std::int32_t number, Ghosts ghosts);

/// Returns the nodes of a group of the whole mesh that belong to the part, numbered in the part.
std::vector<VertexIndex> nodes_in_part(const std::vector<VertexIndex>& nodes_of_whole, const MeshPart& part);

}  // namespace geomesh::geomodel
