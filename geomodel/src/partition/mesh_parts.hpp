// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Describes the cells and nodes of each part of a mesh, and which of them it shares with other parts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"
#include "solver_mesh/face_sides.hpp"

namespace geomesh::geomodel {

/// Whether a part also has the cells of other parts that touch its own cells in a node (ghosts).
enum class Ghosts { none, one_layer };

struct MeshPart {
  std::int32_t number = 0;         ///< from 0
  std::vector<std::size_t> cells;  ///< rows of the mesh part's tetrahedra: its own cells, then ghosts, both ascending
  std::size_t n_own = 0;
  std::vector<VertexIndex> nodes;  ///< rows, in the whole mesh, of the part's points and midpoint nodes, ascending

  /// Converts a node's row in the whole mesh to its position in the part's `nodes`; no_vertex if it is not in the part.
  VertexIndex local(VertexIndex row) const;
};

/// A face between two parts of a mesh, as seen from one of them.
struct BorderFace {
  std::size_t cell;
  unsigned opposite;  ///< position (0 to 3) in the tetrahedron `cell` of the vertex opposite the face
  std::int32_t other_part;
};

/// Description of one part of a mesh that no process has as a whole. The process has a mesh with only the tetrahedra
/// and ghosts of this part, but all points, faces and edges of the model.
struct GivenPart {
  std::int32_t number = 0, n_parts = 1;
  std::vector<std::int32_t> part_of_cell;  ///< by row
  /// Number in the whole mesh of each cell and of each node. Cells are numbered region by region.
  std::vector<std::int64_t> cell_number, node_number;
  std::vector<std::size_t> first_at_node{0};  ///< for each node: where its list of mesh parts begins in `parts_at`
  std::vector<std::int32_t> parts_at;  ///< ascending numbers of the mesh parts that have a node, for each node in turn
  std::uint64_t n_cells = 0, n_nodes = 0;  ///< numbers of cells and nodes of the whole mesh
};

class MeshParts {
 public:
  /// Divides a mesh into parts. The mesh must outlive this object. Throws as parts_by_metis does.
  MeshParts(const ModelMesh& mesh, std::int32_t n_parts);
  /// Describes a single part of a mesh. The rows of its own cells ascend with their numbers in the whole mesh, and
  /// precede those of ghosts. Such a part has no midpoints.
  MeshParts(const ModelMesh& mesh, GivenPart given);

  std::int32_t n_parts() const { return n_parts_; }
  /// Returns the parts whose cells are available in this process: all parts, or a single one.
  std::vector<std::int32_t> parts_here() const;
  std::size_t cell_number(std::size_t row) const {
    return is_given_ ? static_cast<std::size_t>(given_.cell_number[row]) : row;
  }
  std::size_t node_number(VertexIndex row) const {
    return is_given_ ? static_cast<std::size_t>(given_.node_number[row]) : row;
  }
  std::size_t n_nodes_of_whole() const;
  std::size_t n_cells_of_whole() const;
  std::size_t n_cells_of_region(std::int32_t id) const;
  /// Returns the number of a tetrahedron within its region, from 0; equal to `row_in_block` if the whole mesh is
  /// available.
  std::size_t number_in_region(std::size_t row, std::size_t row_in_block) const;
  std::int32_t part_of_cell(std::size_t row) const { return part_of_cell_[row]; }
  /// Returns the mesh parts that have a cell of their own at a node, ascending.
  std::span<const std::int32_t> parts_at(VertexIndex node) const {
    return {parts_at_.data() + first_[node], first_[node + 1] - first_[node]};
  }
  /// Returns the mesh part that owns a node: the lowest-numbered part with a cell of its own at the node.
  std::int32_t owner_of_node(VertexIndex node) const { return parts_at(node).front(); }

  MeshPart part(std::int32_t number, Ghosts ghosts) const;
  /// Returns the faces of a part that border other parts, by other part and then in an order that both parts share.
  std::vector<BorderFace> border_faces(std::int32_t number) const;

 private:
  void find_parts_at_nodes();
  void find_ghosts();
  template <class F>
  void for_each_node(std::size_t cell, F&& f) const;

  const ModelMesh& mesh_;
  std::int32_t n_parts_;
  GivenPart given_;
  bool is_given_ = false;
  // If only one mesh part is available: number in the whole mesh of the first cell of each region, by region id - 1.
  std::vector<std::size_t> first_of_region_;
  std::vector<Neighbours> across_;
  std::vector<std::int32_t> part_of_cell_;
  std::vector<std::size_t> first_;  // for each node: where its mesh parts begin in parts_at_
  std::vector<std::int32_t> parts_at_;
  std::vector<std::vector<std::size_t>> own_, ghosts_;  // cells by part
};

}  // namespace geomesh::geomodel
