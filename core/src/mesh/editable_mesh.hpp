// SPDX-License-Identifier: MIT
/// @file
/// The tetrahedral mesh that recovery and remeshing edit in place. Recovery adds locked faces to it; remeshing adds
/// surfaces, curves and components. It holds cells, points, and one cell of each vertex.
///
/// There is one change of connectivity, `exchange`: a set of cells is replaced by another that fills the same region.
/// The caller is responsible for the region and for positive cells, and decides both by exact predicates.
///
/// Invariants:
///   1. cell_of(v) of a vertex v in the mesh is a live cell with the vertex v;
///   2. neighbour links are mutual and see their face from both sides (validate_topology);
///   3. every finite cell is exactly positive (validate_geometry).
#pragma once

#include <span>
#include <vector>

#include "common/epoch_marks.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "mesh/face_pairing.hpp"

namespace geomesh {

/// even_completion[i][j] has the other two local vertices k, l such that (i, j, k, l) is an even permutation.
inline constexpr std::uint8_t even_completion[4][4][2] = {{{0, 0}, {2, 3}, {3, 1}, {1, 2}},
                                                          {{3, 2}, {0, 0}, {0, 3}, {2, 0}},
                                                          {{1, 3}, {3, 0}, {0, 0}, {0, 1}},
                                                          {{2, 1}, {0, 2}, {1, 0}, {0, 0}}};

/// Cells and vertices around the edge (a, b) of cell `start`, in one sense of rotation: cell k lies between ring
/// vertices k and k + 1 (modulo the size if closed) and is positive as (a, b, ring[k], ring[k + 1]). If the edge is on
/// the outside of a mesh without ghosts, the ring is open, and starts and ends there. Returns whether it is closed.
bool turn_about_edge(const TetMesh& mesh, CellIndex start, VertexIndex a, VertexIndex b, std::vector<CellIndex>& cells,
                     std::vector<VertexIndex>& ring);

/// `Attributes` preserves the data of cells and faces:
///   FaceMark                        the data that a face of the region's border passes on to the new face in its place
///   FaceMark mark(cells, face)      the mark of a face of a removed cell
///   join(cells, added, other)       links a new face with the one it has met (`other.face` may be invalid)
///   is_closed                       whether each face has two cells (ghosts outside); otherwise the outside is open
///   keeps_inner_marks               whether a face inside the region that is made again keeps its mark
template <class Attributes>
class EditableMesh {
 public:
  using FaceMark = typename Attributes::FaceMark;

  const TetMesh& cells() const { return mesh_; }
  const std::vector<Vec3>& points() const { return points_; }
  const Vec3& point(VertexIndex v) const { return points_[v]; }
  CellIndex cell_of(VertexIndex v) const { return cell_of_[v]; }

  /// Lists the star of v: the cells reached from cell_of(v) through faces with v, in an order that the mesh determines.
  void star(VertexIndex v, EpochMarks& marks, std::vector<CellIndex>& out) const;
  /// Lists the star of v step by step: begin_star() lists the first cell, and grow_star() adds the neighbours of out[k]
  /// that have v and are not in the list yet, to be called for each k < out.size().
  void begin_star(VertexIndex v, EpochMarks& marks, std::vector<CellIndex>& out) const;
  void grow_star(VertexIndex v, std::size_t k, EpochMarks& marks, std::vector<CellIndex>& out) const;

  /// The result of a walk from cell to cell towards a point: why and in which cell it ended.
  struct Walk {
    enum class End { found, outside, at_barrier, too_long };
    End end;
    CellIndex cell;  ///< the last
  };
  /// Walks from a finite cell towards p with exact predicates. Each step crosses the first face from first_face() on
  /// that has p beyond it. Stops before a face for which is_barrier(face) is true, and after `most_steps` steps.
  template <class FirstFace, class IsBarrier>
  Walk walk(const Vec3& p, CellIndex start, std::size_t most_steps, const FirstFace& first_face,
            const IsBarrier& is_barrier) const;

 protected:
  static constexpr std::uint8_t region_flag = 0x80;  ///< flag of a cell that is about to be removed

  EditableMesh() = default;
  EditableMesh(TetMesh mesh, std::vector<Vec3> points)
      : mesh_(std::move(mesh)), points_(std::move(points)), cell_of_(points_.size(), no_cell) {}

  /// Replaces the cells `removed` by `n_added` new cells; make(k) creates new cell k with its attributes.
  /// note_neighbor(cell) is called before the links of a cell beside the region change, note_removal(cell) before a
  /// cell is freed. Throws InternalError if the old and the new cells do not have the same border. O(cells).
  template <class Make, class NoteNeighbor, class NoteRemoval>
  void exchange(std::span<const CellIndex> removed, std::size_t n_added, const Make& make,
                const NoteNeighbor& note_neighbor, const NoteRemoval& note_removal) {
    exchange_by(pairing_, removed, n_added, make, note_neighbor, [&](CellIndex c) {
      note_removal(c);
      mesh_.free_cell(c);
    });
  }
  /// Replaces cells by others with the same border, with a table of faces of the caller, so that several threads can
  /// exchange different cells at once. free(cell) frees a removed cell.
  template <class Make, class NoteNeighbor, class Free>
  void exchange_by(FacePairing<FaceMark>& pairing, std::span<const CellIndex> removed, std::size_t n_added,
                   const Make& make, const NoteNeighbor& note_neighbor, const Free& free);

  TetMesh mesh_;
  std::vector<Vec3> points_;
  std::vector<CellIndex> cell_of_;
  Attributes attributes_;

 private:
  FacePairing<FaceMark> pairing_;
};

template <class Attributes>
void EditableMesh<Attributes>::begin_star(VertexIndex v, EpochMarks& marks, std::vector<CellIndex>& out) const {
  marks.begin();
  out.assign(1, cell_of_[v]);
  marks.mark(cell_of_[v]);
}

template <class Attributes>
void EditableMesh<Attributes>::grow_star(VertexIndex v, std::size_t k, EpochMarks& marks,
                                         std::vector<CellIndex>& out) const {
  const TetMesh::Cell& cell = mesh_.cells()[out[k]];
  for (unsigned i = 0; i < 4; ++i) {
    const FaceRef n = cell.neighbors[i];
    if (cell.vertices[i] == v || (!Attributes::is_closed && !n.valid())) continue;
    if (!marks.mark_first(n.cell())) continue;
    __builtin_prefetch(mesh_.cells() + n.cell());
    out.push_back(n.cell());
  }
}

template <class Attributes>
void EditableMesh<Attributes>::star(VertexIndex v, EpochMarks& marks, std::vector<CellIndex>& out) const {
  begin_star(v, marks, out);
  for (std::size_t k = 0; k < out.size(); ++k) grow_star(v, k, marks, out);
}

template <class Attributes>
template <class FirstFace, class IsBarrier>
typename EditableMesh<Attributes>::Walk EditableMesh<Attributes>::walk(const Vec3& p, CellIndex start,
                                                                       std::size_t most_steps,
                                                                       const FirstFace& first_face,
                                                                       const IsBarrier& is_barrier) const {
  CellIndex c = start;
  for (std::size_t step = 0; step < most_steps; ++step) {
    if (Attributes::is_closed && mesh_.is_ghost(c)) return {Walk::End::outside, c};
    const Tetrahedron& v = mesh_.vertices(c);
    const unsigned first = first_face();
    unsigned exit = 4;
    for (unsigned k = 0; k < 4 && exit == 4; ++k) {
      const unsigned i = (first + k) & 3u;
      const auto& l = face_vertices[i];
      if (orient3d(points_[v[l[0]]], points_[v[l[1]]], points_[v[l[2]]], p) == Sign::negative) exit = i;
    }
    if (exit == 4) return {Walk::End::found, c};
    if (is_barrier(FaceRef(c, exit))) return {Walk::End::at_barrier, c};
    c = mesh_.neighbor_cell(c, exit);
  }
  return {Walk::End::too_long, c};
}

template <class Attributes>
template <class Make, class NoteNeighbor, class Free>
void EditableMesh<Attributes>::exchange_by(FacePairing<FaceMark>& pairing, std::span<const CellIndex> removed,
                                           std::size_t n_added, const Make& make, const NoteNeighbor& note_neighbor,
                                           const Free& free) {
  for (const CellIndex c : removed) mesh_.flags(c) |= region_flag;
  pairing.begin(4 * (removed.size() + n_added));
  for (const CellIndex c : removed)
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef outer = mesh_.neighbor(c, i);
      if (outer.valid() && mesh_.flags(outer.cell()) & region_flag) {
        if constexpr (Attributes::keeps_inner_marks)
          if (const FaceMark mark = attributes_.mark(mesh_, FaceRef(c, i)); mark != FaceMark{})
            pairing.await_inner(face_key(mesh_.vertices(c), i), mark);
        continue;
      }
      if (outer.valid()) note_neighbor(outer.cell());
      pairing.await_outer(face_key(mesh_.vertices(c), i), outer, attributes_.mark(mesh_, FaceRef(c, i)));
    }
  for (const CellIndex c : removed) {
    mesh_.flags(c) = 0;
    free(c);
  }
  for (std::size_t k = 0; k < n_added; ++k) {
    const CellIndex c = make(k);
    for (unsigned i = 0; i < 4; ++i)
      if (const auto* other = pairing.meet(face_key(mesh_.vertices(c), i), FaceRef(c, i)))
        attributes_.join(mesh_, FaceRef(c, i), *other);
  }
  GEOMESH_CHECK(pairing.n_outer_waiting() == 0 && (!Attributes::is_closed || pairing.n_added_waiting() == 0));
}

}  // namespace geomesh
