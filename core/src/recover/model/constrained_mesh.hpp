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

/// The cells around an edge p-q: cells[i] is positive as (p, q, ring[i], ring[i+1]), indices modulo the size.
struct EdgeRing {
  VertexIndex p = no_vertex, q = no_vertex;
  std::vector<CellIndex> cells;
  std::vector<VertexIndex> ring;
};

/// Returns the random numbers that choose among possible steps of a walk through the mesh from vertex a to b. They
/// depend on a and b alone, so that walks do not influence later ones.
inline Random walk_choices(VertexIndex a, VertexIndex b) { return Random(a * 0x9E3779B9u + b); }

/// Locks of faces, stored in the flags of cells.
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
  /// The `n_input` vertices of the model come first, followed by the eight of the box.
  ConstrainedMesh(TetMesh mesh, std::vector<Vec3> points, std::size_t n_input);

  /// Returns the cells and the points; the mesh must not be used afterwards.
  void release(TetMesh& cells, std::vector<Vec3>& points) {
    cells = std::move(mesh_);
    points = std::move(points_);
  }

  std::size_t n_input() const { return n_input_; }
  bool is_box_vertex(VertexIndex v) const { return v >= n_input_ && v < n_input_ + 8; }
  /// Adds a vertex that is not yet in any cell.
  VertexIndex add_point(const Vec3& p);
  VertexIndex add_point(ExactPlace place);
  /// Moves a vertex. The caller must have checked that all cells at the vertex, if any, remain positive.
  void move_point(VertexIndex v, const Vec3& p) {
    exact_.erase(v);
    points_[v] = p;
  }
  void move_point(VertexIndex v, ExactPlace place) {
    points_[v] = place.nearest();
    exact_.set(v, std::move(place));
  }
  void drop_last_point();

  /// Returns whether the place of v is not a double but an exact sum of doubles (exact_places.hpp).
  bool is_exact(VertexIndex v) const { return exact_.contains(v); }
  bool has_exact_places() const { return !exact_.empty(); }
  const ExactPlaces& exact_places() const { return exact_; }
  /// Returns coordinate i (0 to 2) of vertex v exactly, as a sum of doubles.
  exact::LongExpansion coordinate(VertexIndex v, std::size_t i) const { return exact_.coordinate(points_, v, i); }
  /// Returns the vector from one vertex to another, which is accurate even if their nearest doubles are equal.
  Vec3 offset(VertexIndex from, VertexIndex to) const {
    return exact_.empty() ? points_[to] - points_[from] : exact_.offset(points_, from, to);
  }
  /// Returns error terms for determinants of vectors from one vertex to others, whose coordinates were rounded.
  ExactPlaces::OffsetError offset_error(VertexIndex from, std::span<const VertexIndex> to) const {
    return exact_.offset_error(points_, from, to);
  }

  Sign orient(VertexIndex a, VertexIndex b, VertexIndex c, VertexIndex d) const {
    if (!exact_.empty() && (is_exact(a) || is_exact(b) || is_exact(c) || is_exact(d)))
      return exact_.orient(points_, {a, b, c, d});
    return orient3d(points_[a], points_[b], points_[c], points_[d]);
  }
  /// Returns the orientation of the coordinates i and j of three vertices.
  Sign orient_flat(VertexIndex a, VertexIndex b, VertexIndex c, std::size_t i, std::size_t j) const {
    return exact_.orient_flat(points_, {a, b, c}, i, j);
  }
  bool positive(const Tetrahedron& t) const { return orient(t[0], t[1], t[2], t[3]) == Sign::positive; }

  bool in_mesh(VertexIndex v) const { return cell_of_[v] != no_cell; }
  void forget(VertexIndex v) { cell_of_[v] = no_cell; }

  bool is_locked(FaceRef f) const { return FaceLocks::mark(mesh_, f); }
  void lock(FaceRef f) { FaceLocks::lock(mesh_, f, mesh_.mirror(f)); }

  /// Collects all cells with v (including ghosts). The order depends on the mesh alone.
  void star(VertexIndex v, std::vector<CellIndex>& out) { EditableMesh::star(v, marks_, out); }
  /// Returns marks on cells for temporary use by the caller. Each call of star() clears them.
  EpochMarks& marks() { return marks_; }
  /// Returns the vertices connected with v by an edge, without the infinite one, sorted.
  std::vector<VertexIndex> neighbors(VertexIndex v);
  /// Returns a cell with both vertices a and b, or no_cell. Walks around a towards b, so a must be in the mesh; exact.
  CellIndex find_edge(VertexIndex a, VertexIndex b);
  /// Returns a cell with the vertices a and b, or no_cell. Examines `hint` first: any cell, a dead one or no_cell.
  CellIndex find_edge(VertexIndex a, VertexIndex b, CellIndex hint) {
    const bool is_there =
        hint < mesh_.n_slots() && mesh_.is_live(hint) && mesh_.has_vertex(hint, a) && mesh_.has_vertex(hint, b);
    return is_there ? hint : find_edge(a, b);
  }
  /// Collects the cells around edge a-b, of which `cell` is one. Returns false if a ghost is among them.
  bool ring(CellIndex cell, VertexIndex a, VertexIndex b, EdgeRing& out) const;
  /// Returns the face a,b,c from the cell above it (whose apex d makes (a,b,c,d) positive), or an invalid reference.
  FaceRef find_face(VertexIndex a, VertexIndex b, VertexIndex c);
  /// Returns the face a,b,c from the cell above it, or an invalid reference, by turning around a-b from `cell`, which
  /// has a and b. O(cells around a-b).
  FaceRef find_face_about(CellIndex cell, VertexIndex a, VertexIndex b, VertexIndex c) const;
  /// Returns the face a,b,c from the cell above it. `cell` has all three vertices and may be above or below the face.
  FaceRef face_in_cell(CellIndex cell, VertexIndex a, VertexIndex b, VertexIndex c) const;

  /// Makes one step of a walk in the star of a towards b: returns a face of cell c at vertex a beyond whose plane b
  /// lies, chosen by `random` from several. Returns 4 if the cone of c at a contains b.
  unsigned exit_towards(CellIndex c, VertexIndex a, VertexIndex b, Random& random) const;

  /// Returns a finite cell that contains p inside or on its boundary, walking from `start` (from its finite neighbour
  /// if it is a ghost); no_cell if p is outside the box. Exact.
  CellIndex locate(const Vec3& p, CellIndex start);

  /// Replaces `old_cells` by `tetrahedra`. The two sets have the same boundary faces (checked); locks of faces that
  /// still exist afterwards are kept, also inside. The caller must ensure positivity. Indices of the new cells:
  /// last_created(). O(k log k).
  void replace(std::span<const CellIndex> old_cells, std::span<const Tetrahedron> tetrahedra);
  const std::vector<CellIndex>& last_created() const { return created_; }

  /// Finds the cavity of an insertion: the cells that `in_cavity(cell)` accepts and that are connected through faces
  /// with `first`, which is one of them. The cells remain marked until replace_by_star. No face may be locked and no
  /// undo may be open. O(cells tested).
  template <class Test>
  void find_cavity(CellIndex first, const Test& in_cavity, std::vector<CellIndex>& cavity);
  /// Sets the flags by which replace_by_star recognises the cells of a cavity; unmark_cavity removes them.
  void mark_cavity(std::span<const CellIndex> cavity) {
    for (const CellIndex c : cavity) mesh_.flags(c) |= region_flag;
  }
  void unmark_cavity(std::span<const CellIndex> cavity) {
    for (const CellIndex c : cavity) mesh_.flags(c) &= static_cast<std::uint8_t>(~region_flag);
  }
  bool is_in_cavity(CellIndex c) const { return mesh_.flags(c) & region_flag; }
  /// Replaces a cavity from find_cavity by the cells that connect its boundary with x. Cells are linked by turning
  /// around the edges of the boundary inside the cavity, so that no table of faces is needed. The caller must ensure
  /// positivity; new cells: last_created(). O(k).
  void replace_by_star(std::span<const CellIndex> cavity, VertexIndex x);

  /// n_changes() counts the changes of the mesh that were not rolled back. last_change(v) is this count after the last
  /// change of a cell that has v.
  std::size_t n_changes() const { return n_changes_; }
  std::size_t last_change(VertexIndex v) const { return v < last_change_.size() ? last_change_[v] : 0; }

  /// roll_back(mark) undoes all replacements of cells since the call of mark() that returned `mark`; slot numbers may
  /// differ. docs/decisions/house.md explains why remeshing has a journal of its own.
  std::size_t mark();
  void roll_back(std::size_t mark);
  /// Ends the undo that mark() began and keeps the changes.
  void keep();

  void reseed(std::uint32_t seed) { random_ = Random(seed); }
  /// Returns deterministic pseudo-random numbers.
  unsigned random(unsigned n) { return random_.below(n); }

 private:
  /// Flag of cells that the search for a cavity has examined and left out.
  static constexpr std::uint8_t tested_flag = 0x40;

  struct CreatedCell {
    Tetrahedron vertices;
    CellIndex slot;  ///< slot of the mesh in which the cell was stored when it was created
  };
  /// Rows in the journal at which the lists of cells that one exchange of cells removed and created begin.
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
  std::vector<FaceRef> star_faces_;  ///< for each new cell of a star, its face on the former cavity's boundary
  std::vector<CellIndex> tested_;    ///< cells that a search for a cavity has tested and not added to it
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
