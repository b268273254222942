// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Cells and nodes of a VTU file, for a whole mesh or one part: tetrahedra, prisms, and in a single grid also faces,
/// edges of curves and named points.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "geomesh/geomodel/model_mesh.hpp"
#include "geomesh/geomodel/write_options.hpp"
#include "partition/mesh_parts.hpp"

namespace geomesh::geomodel {

enum class VtuCells : std::size_t { tetrahedra, prisms, faces, edges, points };
inline constexpr std::size_t n_vtu_cell_kinds = 5;

class VtuLayout {
 public:
  /// Lays out the cells of a VTU file: those of a mesh, or of one part, which has only tetrahedra. For the whole mesh
  /// `part` is null. Mesh and part must outlive this object.
  VtuLayout(const ModelMesh& mesh, const WriteOptions& options, const MeshPart* part = nullptr);

  std::size_t n_nodes() const { return n_nodes_; }
  /// Returns the row in the mesh of a node of the VTU file. Midpoints follow the points.
  std::size_t node_row(std::size_t i) const { return part_ ? part_->nodes[i] : i; }
  const MeshPart* part() const { return part_; }

  std::size_t n_cells() const { return first_cell_.back(); }
  std::size_t n_entries() const { return first_entry_.back(); }
  /// Calls `f(kind, row)` for a cell of the VTU file: its kind (face ...), and its row among the mesh's cells of it.
  template <class F>
  auto visit(std::size_t cell, F&& f) const {
    const std::size_t k = find(first_cell_, cell), row = cell - first_cell_[k];
    return f(static_cast<VtuCells>(k), part_ ? part_->cells[row] : row);
  }
  std::uint8_t type(std::size_t cell) const;
  /// VTK offset of a cell: the end of its nodes in the list of all cells' nodes.
  std::int64_t end_of(std::size_t cell) const;
  /// number in the file of the node at position `entry` in the concatenated node lists of all cells
  VertexIndex node(std::size_t entry) const;
  /// Id of the region, cohesive layer, surface, curve or point to which a cell belongs.
  std::int32_t id(std::size_t cell) const;

 private:
  using Firsts = std::array<std::size_t, n_vtu_cell_kinds + 1>;
  static std::size_t find(const Firsts& firsts, std::size_t i) {
    std::size_t k = 0;
    while (i >= firsts[k + 1]) ++k;
    return k;
  }
  VertexIndex node_of_mesh(std::size_t entry) const;

  const ModelMesh* mesh_;
  const MeshPart* part_;
  std::size_t n_nodes_;
  std::array<std::size_t, n_vtu_cell_kinds> nodes_;
  Firsts first_cell_, first_entry_;
};

}  // namespace geomesh::geomodel
