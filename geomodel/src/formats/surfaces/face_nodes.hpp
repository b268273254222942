// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Nodes of the faces of a mesh, for files that contain only surfaces.
#pragma once

#include <cstdint>
#include <vector>

#include "formats/codes/each_cell.hpp"

namespace geomesh::geomodel {

struct FaceNodes {
  std::vector<VertexIndex> rows;  ///< rows in the mesh of the nodes of faces, ascending
  /// For each point of the mesh: its position in `rows` (the nodes of some faces); undefined for other points.
  std::vector<std::uint32_t> number_of;
};

/// Returns the nodes of the faces of some blocks of cells. O(nodes of the mesh).
inline FaceNodes face_nodes(const SolverMesh& mesh, const std::vector<std::size_t>& blocks) {
  std::vector<bool> used(mesh.n_nodes(), false);
  for (const std::size_t b : blocks)
    for (const VertexIndex v : mesh.blocks[b].nodes) used[v] = true;
  FaceNodes nodes;
  nodes.number_of.resize(used.size(), 0);
  for (VertexIndex v = 0; v < used.size(); ++v)
    if (used[v]) {
      nodes.number_of[v] = static_cast<std::uint32_t>(nodes.rows.size());
      nodes.rows.push_back(v);
    }
  return nodes;
}

inline FaceNodes face_nodes(const SolverMesh& mesh) {
  std::vector<std::size_t> blocks;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    if (mesh.blocks[b].shape == CellShape::triangle) blocks.push_back(b);
  return face_nodes(mesh, blocks);
}

}  // namespace geomesh::geomodel
