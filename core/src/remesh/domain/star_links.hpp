// SPDX-License-Identifier: MIT
/// @file
/// Makes the cells of a star neighbours of each other.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "remesh/domain/mesh_elements.hpp"

namespace geomesh::remesh {

/// Vertices of the border are numbered as they appear. A square table maps each directed edge to its cell; each entry
/// is written before it is read, so nothing has to be hashed, sorted or cleared.
class StarLinks {
 public:
  static constexpr std::size_t most_faces = 124;  ///< a sphere of this many triangles has 64 vertices

  /// Makes cells[k], which is (face k of the border, apex), neighbours of each other around the apex. There are at most
  /// `most_faces`. Throws InternalError if the border is not closed.
  void link(TetMesh& mesh, std::span<const StarFace> border, std::span<const CellIndex> cells) {
    number(border);
    const std::size_t n = border.size();
    for (std::size_t k = 0; k < n; ++k)
      for (unsigned j = 0; j < 3; ++j) entry(k, j, (j + 1) % 3) = FaceRef(cells[k], (j + 2) % 3);
    for (std::size_t k = 0; k < n; ++k)
      for (unsigned j = 0; j < 3; ++j) {
        const FaceRef across = entry(k, (j + 1) % 3, j), own(cells[k], (j + 2) % 3);
        GEOMESH_CHECK(is_across(mesh, border[k], mesh.vertex(cells[k], 3), across, j));
        mesh.cells()[own.cell()].neighbors[own.face()] = across;
      }
  }

 private:
  static constexpr unsigned side = 64;
  static constexpr std::uint16_t none = 0xFFFF;

  void number(std::span<const StarFace> border) {
    numbered_.clear();
    for (std::size_t k = 0; k < border.size(); ++k)
      for (unsigned j = 0; j < 3; ++j) {
        const VertexIndex v = border[k].vertices[j];
        if (v >= number_.size()) number_.resize(v + v / 4 + 1, none);
        if (number_[v] == none) {
          GEOMESH_CHECK(numbered_.size() < side);
          number_[v] = static_cast<std::uint16_t>(numbered_.size());
          numbered_.push_back(v);
        }
        of_face_[k][j] = number_[v];
      }
    for (const VertexIndex v : numbered_) number_[v] = none;
  }
  FaceRef& entry(std::size_t k, unsigned from, unsigned to) {
    return table_[of_face_[k][from] * side + of_face_[k][to]];
  }
  /// Returns whether the table's entry is a face of this star at the edge (j, j + 1) of the border face.
  static bool is_across(TetMesh& mesh, const StarFace& f, VertexIndex apex, FaceRef across, unsigned j) {
    if (!across.valid() || across.cell() >= mesh.n_slots()) return false;
    const Tetrahedron& t = mesh.vertices(across.cell());
    const unsigned i = across.face();
    return i < 3 && t[3] == apex && t[(i + 1) % 3] == f.vertices[(j + 1) % 3] && t[(i + 2) % 3] == f.vertices[j];
  }

  std::vector<std::uint16_t> number_;  // by vertex
  std::vector<VertexIndex> numbered_;
  std::array<std::array<std::uint16_t, 3>, most_faces> of_face_;
  std::array<FaceRef, side * side> table_;
};

}  // namespace geomesh::remesh
