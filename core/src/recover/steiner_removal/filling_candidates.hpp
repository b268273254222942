// SPDX-License-Identifier: MIT
/// @file
/// Finds the tetrahedra of which a filling of a region can consist: those that contain no other vertex, and whose edges
/// and faces cross neither the boundary nor required items. Tetrahedra without a partner on the other side of a face
/// are then removed repeatedly.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "recover/model/constraints.hpp"
#include "recover/operations/side_masks.hpp"
#include "recover/steiner_removal/region_filling.hpp"

namespace geomesh::recover {

/// Candidates for the cells of a region. A face is a numbered triangle of local vertices; side 2 f of face f is above
/// it (with its vertices in increasing order), side 2 f + 1 is below.
class FillingCandidates {
 public:
  struct Cell {
    std::array<LocalVertex, 4> vertices;  ///< increasing
    bool is_positive;                     ///< in that order
    std::array<std::uint32_t, 4> sides;   ///< by face of the cell: number of the face's side where the cell lies
    VertexMask mask() const { return bit(vertices[0]) | bit(vertices[1]) | bit(vertices[2]) | bit(vertices[3]); }
  };

  FillingCandidates(const ConstrainedMesh& mesh, const Constraints& constraints, const Region& region);

  /// Finds all tetrahedra that may be cells of a filling of the region. Returns false if there evidently is no filling,
  /// because a boundary face has no such tetrahedron on its inner side. O(n^4) for n vertices.
  bool find();

  /// Returns the possible cells of fillings of the region, in lexicographic order of their vertices.
  const std::vector<Cell>& cells() const { return cells_; }
  /// Returns the rows in cells() of the possible tetrahedra on one side of a face; `side` is the number of that side.
  std::span<const std::uint32_t> beside(std::uint32_t side) const {
    return {rows_.data() + begin_[side], rows_.data() + end_[side]};
  }
  std::size_t n_faces() const { return is_required_.size() / 2; }
  bool is_boundary(std::size_t face) const { return is_required_[2 * face] || is_required_[2 * face + 1]; }
  /// Returns whether every filling of the region has a cell on this side of a face, which is on the region's boundary.
  bool is_required(std::uint32_t side) const { return is_required_[side] != 0; }

  LocalVertex local(VertexIndex v) const;
  Tetrahedron global(const Cell& c) const;

 private:
  LocalTriangle local(const Triangle& t) const { return {local(t[0]), local(t[1]), local(t[2])}; }
  VertexMask all() const { return n_ == 64 ? ~VertexMask{0} : (VertexMask{1} << n_) - 1; }
  void force_edge(LocalVertex a, LocalVertex b);
  void mark_required();
  VertexMask crossing(LocalVertex a, const LocalTriangle& t);
  void find_allowed_edges();
  void forbid_edges_in_plane(const LocalTriangle& t);
  void forbid_edges_through(const LocalTriangle& t);
  void find_allowed_faces();
  void forbid_faces_about(LocalVertex a, LocalVertex b);
  void forbid_face(const LocalTriangle& t);
  VertexMask& thirds(LocalVertex a, LocalVertex b) { return thirds_[std::size_t{a} * n_ + b]; }
  void gather();
  void gather_above_face(LocalVertex a, LocalVertex b, LocalVertex c);
  bool holds_another(const Cell& c) const;
  void list_by_side();
  bool prune();

  const Constraints& constraints_;
  const Region& region_;
  std::size_t n_;
  SideMasks sides_;
  std::vector<LocalTriangle> boundary_;
  std::vector<VertexMask> forced_;   ///< by vertex of the region: vertices to which new cells must connect it
  std::vector<VertexMask> allowed_;  ///< by vertex of the region: vertices to which new cells may connect it
  std::vector<VertexMask> thirds_;   ///< by pair of the region's vertices: vertices with which it may form a face
  std::vector<std::uint8_t> is_required_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> rows_, begin_, end_;  ///< cells by side
};

}  // namespace geomesh::recover
