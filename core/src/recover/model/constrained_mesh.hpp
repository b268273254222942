// SPDX-License-Identifier: MIT
/// @file
/// The mesh under recovery: the editable mesh with locked faces.
///
/// Invariants, beside those of EditableMesh:
///   1. every finite cell is exactly positive, in the doubles of `points` and the exact places of `exact_places`;
///   2. bit i of flags(c) is set where face i of c is a recovered subfacet ("locked"), on both of its cells;
///   3. the model lies strictly inside a box of eight auxiliary vertices (`is_box_vertex`), so that every constraint is
///   interior and
///      ghost cells are never touched.
#pragma once

#include <span>
#include <vector>

#include "common/flat_map.hpp"
#include "common/random.hpp"
#include "mesh/editable_mesh.hpp"
#include "recover/exact/exact_places.hpp"

namespace geomesh::recover {

/// The cells about an edge p-q: cells[i] is positive as (p, q, ring[i], ring[i+1]), indices modulo the size.
struct EdgeRing {
  VertexIndex p = no_vertex, q = no_vertex;
  std::vector<CellIndex> cells;
  std::vector<VertexIndex> ring;
};

/// Choices of a walk's direction. They depend on where it starts and ends alone, not on walks before it, so that
/// looking something up changes nothing.
inline Random walk_choices(VertexIndex a, VertexIndex b) { return Random(a * 0x9E3779B9u + b); }

/// Locks of faces, in the cells' flags.
struct FaceLocks {
  using FaceMark = bool;
  static constexpr bool is_closed = true;
  static constexpr bool keeps_inner_marks = true;

  static bool mark(const TetMesh& cells, FaceRef f) { return (cells.flags(f.cell()) >> f.face()) & 1u; }
  static void lock(TetMesh& cells, FaceRef f, FaceRef g) {
    cells.flags(f.cell()) |= static_cast<std::uint8_t>(1u << f.face());
    cells.flags(g.cell()) |= static_cast<std::uint8_t>(1u << g.face());
  }
  static void join(TetMesh& cells, FaceRef added, const FacePairing<bool>::Entry& other) {
    cells.link(added, other.face);
    if (other.mark) lock(cells, added, other.face);
  }
};

class ConstrainedMesh : public EditableMesh<FaceLocks> {
 public:
  /// `n_input` vertices of the model come first, then the eight of the box.
  ConstrainedMesh(TetMesh mesh, std::vector<Vec3> points, std::size_t n_input);

  /// Gives the cells and the points back; nothing may be asked of the mesh afterwards.
  void release(TetMesh& cells, std::vector<Vec3>& points) {
    cells = std::move(mesh_);
    points = std::move(points_);
  }

  std::size_t n_input() const { return n_input_; }
  bool is_box_vertex(VertexIndex v) const { return v >= n_input_ && v < n_input_ + 8; }
  /// A vertex not yet in any cell.
  VertexIndex add_point(const Vec3& p);
  VertexIndex add_point(ExactPlace place);
  /// Only for vertices whose star the caller has checked (or that is in no cell).
  void move_point(VertexIndex v, const Vec3& p) {
    exact_.erase(v);
    points_[v] = p;
  }
  void move_point(VertexIndex v, ExactPlace place) {
    points_[v] = place.nearest();
    exact_.set(v, std::move(place));
  }
  void drop_last_point();

  /// Whether the place of v is no double but an exact sum of doubles (exact_places.hpp).
  bool is_exact(VertexIndex v) const { return exact_.contains(v); }
  bool has_exact_places() const { return !exact_.empty(); }
  const ExactPlaces& exact_places() const { return exact_; }
  /// Of any vertex.
  exact::LongExpansion coordinate(VertexIndex v, std::size_t i) const { return exact_.coordinate(points_, v, i); }
  /// From one vertex to another: accurate where their nearest doubles are equal.
  Vec3 offset(VertexIndex from, VertexIndex to) const {
    return exact_.empty() ? points_[to] - points_[from] : exact_.offset(points_, from, to);
  }
  /// Of those offsets, in filters of determinants.
  ExactPlaces::OffsetError offset_error(VertexIndex from, std::span<const VertexIndex> to) const {
    return exact_.offset_error(points_, from, to);
  }

  Sign orient(VertexIndex a, VertexIndex b, VertexIndex c, VertexIndex d) const {
    if (!exact_.empty() && (is_exact(a) || is_exact(b) || is_exact(c) || is_exact(d)))
      return exact_.orient(points_, {a, b, c, d});
    return orient3d(points_[a], points_[b], points_[c], points_[d]);
  }
  /// Of the coordinates i and j.
  Sign orient_flat(VertexIndex a, VertexIndex b, VertexIndex c, std::size_t i, std::size_t j) const {
    return exact_.orient_flat(points_, {a, b, c}, i, j);
  }
  bool positive(const Tetrahedron& t) const { return orient(t[0], t[1], t[2], t[3]) == Sign::positive; }

  bool in_mesh(VertexIndex v) const { return cell_of_[v] != no_cell; }
  void forget(VertexIndex v) { cell_of_[v] = no_cell; }

  bool is_locked(FaceRef f) const { return FaceLocks::mark(mesh_, f); }
  void lock(FaceRef f) { FaceLocks::lock(mesh_, f, mesh_.mirror(f)); }

  /// All cells with v (ghosts too). The order depends on the mesh alone.
  void star(VertexIndex v, std::vector<CellIndex>& out) { EditableMesh::star(v, marks_, out); }
  /// Scratch for marks on cells. A star uses it too.
  EpochMarks& marks() { return marks_; }
  /// Vertices joined with v by an edge, the infinite one left out, sorted.
  std::vector<VertexIndex> neighbors(VertexIndex v);
  /// A cell with both vertices, or no_cell. Walks about a towards b, so a must be in the mesh; exact.
  CellIndex find_edge(VertexIndex a, VertexIndex b);
  /// Looks into the cell `hint` first, which may be any, a dead one or no_cell too.
  CellIndex find_edge(VertexIndex a, VertexIndex b, CellIndex hint) {
    const bool is_there =
        hint < mesh_.n_slots() && mesh_.is_live(hint) && mesh_.has_vertex(hint, a) && mesh_.has_vertex(hint, b);
    return is_there ? hint : find_edge(a, b);
  }
  /// The cells about edge a-b, `cell` being one. False where a ghost is among them.
  bool ring(CellIndex cell, VertexIndex a, VertexIndex b, EdgeRing& out) const;
  /// The face a,b,c from the cell above it (whose apex d makes (a,b,c,d) positive), or an invalid reference.
  FaceRef find_face(VertexIndex a, VertexIndex b, VertexIndex c);
  /// As find_face, where `cell` has a and b. O(cells about a-b).
  FaceRef find_face_about(CellIndex cell, VertexIndex a, VertexIndex b, VertexIndex c) const;
  /// As find_face, for one given cell with all three.
  FaceRef face_in_cell(CellIndex cell, VertexIndex a, VertexIndex b, VertexIndex c) const;

  /// For a walk in the star of a towards b: a face of cell c, which has a, beyond whose plane b lies; of several one by
  /// `random`. 4 where c's cone about a has b.
  unsigned exit_towards(CellIndex c, VertexIndex a, VertexIndex b, Random& random) const;

  /// A finite cell that has p inside or on its boundary, walking from `start` (of a ghost: from beside it); no_cell
  /// where p is outside the box. Exact.
  CellIndex locate(const Vec3& p, CellIndex start);

  /// Replaces `old_cells` by `tetrahedra`. The two sets have the same boundary faces (checked); locks are kept
  /// where the face is there afterwards, inside too. The caller answers for positivity. Indices of the new cells:
  /// last_created(). O(k log k).
  void replace(std::span<const CellIndex> old_cells, std::span<const Tetrahedron> tetrahedra);
  const std::vector<CellIndex>& last_created() const { return created_; }

  /// The cavity of an insertion, while nothing is locked and no undo is open: the cells that `in_cavity(cell)` accepts,
  /// searched from `first`, which is one of them, through faces. They stay marked until replace_by_star. O(cells
  /// tested).
  template <class Test>
  void find_cavity(CellIndex first, const Test& in_cavity, std::vector<CellIndex>& cavity);
  /// Puts these marks on the same cells again, or takes them off.
  void mark_cavity(std::span<const CellIndex> cavity) {
    for (const CellIndex c : cavity) mesh_.flags(c) |= region_flag;
  }
  void unmark_cavity(std::span<const CellIndex> cavity) {
    for (const CellIndex c : cavity) mesh_.flags(c) &= static_cast<std::uint8_t>(~region_flag);
  }
  bool is_in_cavity(CellIndex c) const { return mesh_.flags(c) & region_flag; }
  /// Replaces a cavity from find_cavity by the cells that join its boundary with x. Cells are linked by turning about
  /// the edges of the boundary inside the cavity, so that no table of faces is needed. The caller answers for
  /// positivity; new cells: last_created(). O(k).
  void replace_by_star(std::span<const CellIndex> cavity, VertexIndex x);

  /// Number of changes so far, and its value after the last one of a cell with v. What has been rolled back is none.
  std::size_t n_changes() const { return n_changes_; }
  std::size_t last_change(VertexIndex v) const { return v < last_change_.size() ? last_change_[v] : 0; }

  /// Undo of replacements: mark() .. roll_back(mark) restores the cells (vertices and locks, not slot numbers). Why it
  /// is not remeshing's journal: docs/decisions/house.md.
  std::size_t mark();
  void roll_back(std::size_t mark);
  /// Ends what mark() began, keeping the changes.
  void keep();

  /// Another seed, other choices.
  void reseed(std::uint32_t seed) { random_ = Random(seed); }
  /// Deterministic source of choices.
  unsigned random(unsigned n) { return random_.below(n); }

 private:
  static constexpr std::uint8_t tested_flag = 0x40;  ///< set while a cavity is searched: found to lie outside it

  struct CreatedCell {
    Tetrahedron vertices;
    CellIndex slot;  ///< that it had then
  };
  /// What each replacement removed and created begins at these rows.
  struct JournalEntry {
    std::size_t removed, created;
  };
  void exchange_cells(std::span<const CellIndex> old_cells, std::span<const Tetrahedron> tetrahedra, bool is_noted);
  void begin_change() {
    ++n_changes_;
    last_change_.resize(points_.size());
  }
  void note_change(const Tetrahedron& t) {
    for (const VertexIndex v : t)
      if (v != infinite_vertex) last_change_[v] = n_changes_;
  }
  FaceRef boundary_about_edge(CellIndex cell, unsigned exit, VertexIndex p, VertexIndex q) const;

  ExactPlaces exact_;
  std::size_t n_input_;
  std::vector<JournalEntry> journal_;
  std::vector<Tetrahedron> journal_removed_;
  std::vector<CreatedCell> journal_created_;
  std::size_t journal_depth_ = 0;
  std::size_t n_changes_ = 0;
  std::vector<std::size_t> last_change_;  ///< by vertex
  std::vector<CellIndex> created_;
  std::vector<FaceRef> star_faces_;  ///< per created cell of a star: the old cell's face under it
  std::vector<CellIndex> tested_;    ///< of a search for a cavity: cells outside it
  EpochMarks marks_;
  Random random_;
};

template <class Test>
void ConstrainedMesh::find_cavity(CellIndex first, const Test& in_cavity, std::vector<CellIndex>& cavity) {
  cavity.assign(1, first);
  tested_.clear();
  mesh_.flags(first) |= region_flag;
  for (std::size_t i = 0; i < cavity.size(); ++i)
    for (unsigned f = 0; f < 4; ++f) {
      const CellIndex n = mesh_.neighbor_cell(cavity[i], f);
      if (mesh_.flags(n) & (region_flag | tested_flag)) continue;
      const bool inside = in_cavity(n);
      (inside ? cavity : tested_).push_back(n);
      mesh_.flags(n) |= inside ? region_flag : tested_flag;
    }
  for (const CellIndex c : tested_) mesh_.flags(c) &= static_cast<std::uint8_t>(~tested_flag);
}

}  // namespace geomesh::recover
