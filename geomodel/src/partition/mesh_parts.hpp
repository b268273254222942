// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which cells and nodes each part of a mesh has, and what it shares with others.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geomesh/geomodel/model_mesh.hpp"
#include "solver_mesh/face_sides.hpp"

namespace geomesh::geomodel {

/// Whether a part also has the cells of others that touch its own in a node.
enum class Ghosts { none, one_layer };

struct MeshPart {
  std::int32_t number = 0;         ///< from 0
  std::vector<std::size_t> cells;  ///< rows of tetrahedra: its own, then ghosts, each ascending
  std::size_t n_own = 0;
  std::vector<VertexIndex> nodes;  ///< rows of points and midpoints, ascending

  /// The place of a row in `nodes`; no_vertex where it is not there.
  VertexIndex local(VertexIndex row) const;
};

/// A face between two parts, as one of them has it.
struct BorderFace {
  std::size_t cell;
  unsigned opposite;  ///< the vertex of `cell` that the face is opposite to
  std::int32_t other_part;
};

class MeshParts {
 public:
  /// The mesh must outlive this. Throws as parts_by_metis.
  MeshParts(const ModelMesh& mesh, std::int32_t n_parts);

  std::int32_t n_parts() const { return n_parts_; }
  std::int32_t part_of_cell(std::size_t row) const { return part_of_cell_[row]; }
  /// Parts with cells of their own at a node, ascending.
  std::span<const std::int32_t> parts_at(VertexIndex node) const {
    return {parts_at_.data() + first_[node], first_[node + 1] - first_[node]};
  }
  /// The lowest part with a cell of its own at the node.
  std::int32_t owner_of_node(VertexIndex node) const { return parts_at(node).front(); }

  MeshPart part(std::int32_t number, Ghosts ghosts) const;
  /// Faces to other parts, by part and then in an order that both sides share.
  std::vector<BorderFace> border_faces(std::int32_t number) const;

 private:
  void find_parts_at_nodes();
  void find_ghosts();
  template <class F>
  void for_each_node(std::size_t cell, F&& f) const;

  const ModelMesh& mesh_;
  std::int32_t n_parts_;
  std::vector<Neighbours> across_;
  std::vector<std::int32_t> part_of_cell_;
  std::vector<std::size_t> first_;  // by node, into parts_at_
  std::vector<std::int32_t> parts_at_;
  std::vector<std::vector<std::size_t>> own_, ghosts_;  // cells by part
};

}  // namespace geomesh::geomodel
