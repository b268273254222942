// SPDX-License-Identifier: MIT
/// @file
/// The mesh that refinement and improvement work on: the editable mesh with several domains, the surfaces between them,
/// and curves, valid after every operation.
///
/// Invariants in addition to those of EditableMesh (validate() checks each):
///   1. a face that is part of a facet carries that facet on both sides, `above` on one side and not on the other;
///   2. two cells of different components never share an untagged face, and a face without neighbour is tagged;
///   3. every registered curve edge is an edge of the mesh.
///
/// Only one operation changes connectivity: `replace`. Every local operation (split, collapse, flip, insertion)
/// computes the cells to remove and to add, checks each new cell with the exact predicate, and then calls `replace`. No
/// operation can therefore cause crossings, and an inadmissible operation is refused before anything is changed. Points
/// that are inserted by thousands go through walled_mesh.hpp instead.
#pragma once

#include <algorithm>
#include <span>

#include "common/flat_map.hpp"
#include "mesh/editable_mesh.hpp"
#include "quality/measure/cell_quality.hpp"
#include "remesh/domain/live_cells.hpp"
#include "remesh/domain/mesh_blocks.hpp"
#include "remesh/domain/mesh_elements.hpp"
#include "remesh/domain/mesh_journal.hpp"

namespace geomesh::remesh {

/// Data stored for each cell: its component, the tags of its faces, and its shape (quality measure).
struct DomainAttributes {
  using FaceMark = FaceTag;
  static constexpr bool is_closed = false;
  static constexpr bool keeps_inner_marks = false;

  FaceTag mark(const TetMesh&, FaceRef f) const { return tags[f.cell()][f.face()]; }
  void join(TetMesh& cells, FaceRef added, const FacePairing<FaceTag>::Entry& other) {
    if (other.face.valid()) cells.link(added, other.face);
    if (other.role == FacePairing<FaceTag>::Role::added) return;
    FaceTag& own = tags[added.cell()][added.face()];
    if (other.mark.constrained())
      own = other.mark;
    else if (own.constrained())  // a new face on the border of the replaced region is on a surface
      tags[other.face.cell()][other.face.face()] = own.opposite();
  }

  /// Makes room for n cells, whose attributes must be set afterwards.
  void grow_to(std::size_t n) {
    component.grow_to(n);
    tags.grow_to(n);
    shape.grow_to(n);
  }
  void truncate(std::size_t n) {
    component.truncate(n);
    tags.truncate(n);
    shape.truncate(n);
  }
  void reserve(std::size_t n) {
    component.reserve(n);
    tags.reserve(n);
    shape.reserve(n);
  }

  PodArray<Index> component;
  PodArray<std::array<FaceTag, 4>> tags;
  PodArray<double> shape;
};

struct MeshPart;
class WalledMesh;

class DomainMesh : public EditableMesh<DomainAttributes> {
 public:
  // Vertices.
  std::size_t n_vertices() const { return points_.size(); }
  VertexKind kind(VertexIndex v) const { return kinds_[v]; }
  /// Returns the patch of a vertex on a surface, the curve class of a vertex on a curve, otherwise no_index.
  Index support(VertexIndex v) const { return supports_[v]; }
  CellIndex incident_cell(VertexIndex v) const { return cell_of(v); }
  VertexIndex add_vertex(const Vec3& p, VertexKind kind, Index support = no_index);
  /// Moves a vertex. The caller must have checked that the cells around it remain positive, and must call refresh_shape
  /// for these cells afterwards.
  void move_vertex(VertexIndex v, const Vec3& p) {
    note_vertex(v);
    points_[v] = p;
  }
  void set_kind(VertexIndex v, VertexKind kind, Index support) {
    note_vertex(v);
    kinds_[v] = kind, supports_[v] = support;
  }
  std::array<Vec3, 3> places(const Triangle& t) const { return {points_[t[0]], points_[t[1]], points_[t[2]]}; }
  std::array<Vec3, 4> places(const Tetrahedron& t) const {
    return {points_[t[0]], points_[t[1]], points_[t[2]], points_[t[3]]};
  }
  Vec3 middle(const Triangle& t) const { return (1.0 / 3) * (points_[t[0]] + points_[t[1]] + points_[t[2]]); }
  Vec3 middle(const Tetrahedron& t) const {
    return 0.25 * (points_[t[0]] + points_[t[1]] + points_[t[2]] + points_[t[3]]);
  }
  /// Returns the normal vector of a face; its length is twice the area.
  Vec3 normal(const Triangle& t) const { return triangle_normal(points_[t[0]], points_[t[1]], points_[t[2]]); }

  // Cells.
  /// The quality measure of the cells. It must be set before the first cell is added.
  const CellQuality& measure() const { return measure_; }
  void set_measure(QualityMeasure measure) { measure_ = CellQuality(measure); }
  CellIndex n_slots() const { return mesh_.n_slots(); }
  std::size_t n_cells() const { return mesh_.n_live(); }
  bool is_live(CellIndex c) const { return mesh_.is_live(c); }
  const Tetrahedron& vertices(CellIndex c) const { return mesh_.vertices(c); }
  Index component(CellIndex c) const { return attributes_.component[c]; }
  LiveCells<DomainMesh> live_cells() const { return LiveCells<DomainMesh>(*this); }
  FaceTag tag(CellIndex c, unsigned face) const { return attributes_.tags[c][face]; }
  FaceTag tag(FaceRef f) const { return tag(f.cell(), f.face()); }
  /// Returns the vertices of a face of a cell, counter-clockwise as seen from the cell.
  Triangle face(FaceRef f) const { return face_of(vertices(f.cell()), f.face()); }
  Triangle face(CellIndex c, unsigned i) const { return face_of(vertices(c), i); }
  /// Returns the vertices of a face that is part of a facet, counter-clockwise as seen from above the facet.
  Triangle facet_face(FaceRef f) const {
    Triangle t = face(f);
    if (!tag(f).above()) std::swap(t[1], t[2]);
    return t;
  }
  /// Returns true for one of the two sides of a constrained face: the one seen from above, or the only one with a cell.
  bool is_surface(FaceRef f) const {
    const FaceTag t = tag(f);
    return t.constrained() && (t.above() || !mesh_.mirror(f).valid());
  }
  /// Calls visit(face) once for each face that is part of a facet.
  template <class Visit>
  void for_each_facet_face(const Visit& visit) const {
    for (const CellIndex c : live_cells())
      for (unsigned i = 0; i < 4; ++i)
        if (const FaceRef f(c, i); is_surface(f) && tag(f).facet() != hull_facet) visit(f);
  }
  double shape(const Triangle& f, const Vec3& apex) const {
    return measure_.shape(points_[f[0]], points_[f[1]], points_[f[2]], apex);
  }
  double shape(const Tetrahedron& t) const { return shape({t[0], t[1], t[2]}, points_[t[3]]); }
  /// Returns whether the tetrahedron of the face f and `apex` is positively oriented, decided exactly.
  bool sees(const Vec3& apex, const Triangle& f) const {
    return orient3d(points_[f[0]], points_[f[1]], points_[f[2]], apex) == Sign::positive;
  }
  bool is_positive(const Tetrahedron& t) const { return sees(points_[t[3]], {t[0], t[1], t[2]}); }
  double shape_of(CellIndex c) const { return attributes_.shape[c]; }
  void refresh_shape(CellIndex c);
  void set_shape(CellIndex c, double shape);
  /// Returns the mesh's time at which a cell with this vertex was last created, or a vertex of such a cell last moved.
  std::uint64_t changed_at(VertexIndex v) const { return changed_[v]; }
  /// Advances the time of the mesh and returns its former value, which is positive. Changes after the call have later
  /// times than changes before it.
  std::uint64_t tick() { return clock_++; }
  bool has_neighbor(CellIndex c, unsigned face) const { return mesh_.neighbor(c, face).valid(); }

  /// Exchanges the removed cells for the added ones, which must fill the same region and be positive. Faces on the
  /// region's border keep their tags and neighbours. Returns the new cells in `created` (in the order of `added`). O(k
  /// log k). Throws InternalError if the two regions do not have the same border.
  void replace(std::span<const CellIndex> removed, std::span<const NewCell> added, std::vector<CellIndex>& created);
  /// Replaces cells of a block while other threads change other blocks. BlockEdit must permit the operation.
  void replace(std::span<const CellIndex> removed, std::span<const NewCell> added, std::vector<CellIndex>& created,
               BlockEdit& block);
  /// Removes a vertex that no live cell uses.
  void remove_vertex(VertexIndex v);

  /// @name Blocks (mesh_blocks.hpp)
  /// @{
  /// Gives a block a clock and free cell slots. Must be called for all blocks before any of them is changed.
  void open_block(BlockEdit& block, std::size_t n_slots);
  /// Returns unused slots of a block to the mesh. Must be called for all blocks once they have been processed.
  void close_block(BlockEdit& block);
  /// @}

  /// @name Separate components
  /// Components can be changed concurrently, as long as only their interior changes.
  /// @{
  /// Moves the cells of each component into a mesh of its own, in ascending order of components. This mesh then has no
  /// cells. O(n).
  std::vector<MeshPart> take_apart();
  /// Inserts the components that take_apart returned, in the same order, with their cells and any new vertices. Faces
  /// shared by components must be unchanged. O(n), plus O(m log m) for m such faces.
  void put_together(std::vector<MeshPart> parts, unsigned threads = 1);
  /// @}

  /// Renumbers the cells along a space-filling curve, so that neighbouring cells are close in memory. There are no free
  /// slots afterwards. O(n log n).
  void sort_cells(unsigned threads = 1);
  /// Returns the vertices in the order of the first cell that contains each of them. If the cells are sorted, vertices
  /// close in space are close in this order.
  std::vector<VertexIndex> vertices_by_cells() const;

  // Patches and curves.
  Index patch_of_facet(Index facet) const { return facet == hull_facet ? hull_patch : facet_patch_[facet]; }
  Index patch_of(FaceTag t) const { return patch_of_facet(t.facet()); }
  void set_facet_patches(std::vector<Index> patches) { facet_patch_ = std::move(patches); }
  std::size_t n_patches() const;
  const CurveClass& curve_class(Index c) const { return curve_classes_[c]; }
  Index add_curve_class(CurveClass c);
  std::size_t n_curve_classes() const { return curve_classes_.size(); }
  /// Returns the class of the curve edge a-b, or no_index if a-b is not on a curve.
  Index curve_of(VertexIndex a, VertexIndex b) const {
    const bool possible = kinds_[a] <= VertexKind::curve && kinds_[b] <= VertexKind::curve;
    return possible ? curves_.find({a, b}) : no_index;
  }
  /// @name Non-manifold vertices of the outside
  /// Cells may meet at a vertex or an edge without being connected by faces there, because the outside lies between
  /// them. `star` and `edge_ring` find only the cells connected with the one from which they start. Such a vertex, and
  /// both ends of such an edge, are therefore corners, for which `is_pinched` returns true. A curve edge between two of
  /// them is not split.
  /// @{
  bool is_pinched(VertexIndex v) const { return v < pinched_.size() && pinched_[v]; }
  bool is_pinched(VertexIndex a, VertexIndex b) const {
    return is_pinched(a) && is_pinched(b) && curve_of(a, b) != no_index;
  }
  void set_pinched(std::vector<bool> pinched) { pinched_ = std::move(pinched); }
  /// @}
  void set_curve(VertexIndex a, VertexIndex b, Index curve_class) {
    note_curve(a, b);
    curves_.insert({a, b}, curve_class);
  }
  void erase_curve(VertexIndex a, VertexIndex b) {
    note_curve(a, b);
    curves_.erase({a, b});
  }
  /// Returns the edges of all curves in ascending order of their vertices.
  std::vector<std::array<VertexIndex, 2>> curve_edges() const { return curves_.sorted_keys(); }

  /// @name Trials: changes that can be undone
  /// Only one trial at a time is possible, by one thread. link_cells, reserve and new patches or curve classes are not
  /// recorded.
  /// @{
  void begin_trial();
  void keep_trial() { journal_.is_open = false; }
  /// Restores the mesh at the start of the undoable trial, with its time and the order of its free slots. O(changes).
  void undo_trial();
  /// Calls visit for each cell that was created, changed or removed since the start of the undoable trial.
  template <class Visit>
  void for_each_trial_cell(const Visit& visit) const {
    for (const SavedCell& s : journal_.cells) visit(s.cell);
    for (CellIndex c = journal_.n_slots; c < n_slots(); ++c) visit(c);
  }
  /// Calls visit for each live cell that the undoable trial has created or changed. A cell of which only a neighbour
  /// was replaced does not count as changed.
  template <class Visit>
  void for_each_cell_of_trial(const Visit& visit) const {
    for (const SavedCell& s : journal_.cells)
      if (is_live(s.cell) && (vertices(s.cell) != s.links.vertices || shape_of(s.cell) != s.shape)) visit(s.cell);
    for (CellIndex c = journal_.n_slots; c < n_slots(); ++c)
      if (is_live(c)) visit(c);
  }
  /// Calls visit for each vertex that the undoable trial created, moved, changed or removed, or whose cell it changed.
  template <class Visit>
  void for_each_trial_vertex(const Visit& visit) const {
    for (const SavedVertex& s : journal_.vertices) visit(s.vertex);
    for (auto v = static_cast<VertexIndex>(journal_.n_vertices); v < n_vertices(); ++v) visit(v);
  }
  /// Calls visit(shape) for each cell that the undoable trial changed or removed, with its shape before the trial.
  template <class Visit>
  void for_each_cell_before_trial(const Visit& visit) const {
    for (const SavedCell& s : journal_.cells)
      if (s.links.vertices[0] != no_vertex) visit(s.shape);
  }
  /// @}

  // Functions that build the mesh. All cells are added first, then linked by link_cells, then their faces are tagged.
  CellIndex add_cell(const Tetrahedron& vertices, Index component, double shape = NewCell::unknown_shape);
  void link_cells();
  void set_tag(CellIndex c, unsigned face, FaceTag t) {
    note_cell(c);
    attributes_.tags[c][face] = t;
  }
  void reserve(std::size_t n_vertices, std::size_t n_cells);

  /// Checks the invariants. Returns a description of the first violation, or an empty string if all hold. O(n log n).
  std::string validate(unsigned threads = 1) const;

 private:
  friend class WalledMesh;
  void fill_part(const std::vector<CellIndex>& cells, const std::vector<CellIndex>& row_of_cell,
                 std::vector<VertexIndex>& row, MeshPart& part) const;
  using OpenFace = std::pair<FaceKey, FaceRef>;
  struct CellCopies;
  void copy_cell(const CellCopies& from, CellIndex c, std::vector<OpenFace>& open);
  void append(MeshPart part, unsigned threads, std::vector<OpenFace>& open);
  /// Makes cells neighbours of each other if they have a face in common.
  void link_faces(std::vector<OpenFace> faces);
  std::string validate_domain() const;
  void note_vertex(VertexIndex v) {
    if (journal_.is_open && journal_.is_new_vertex(v))
      journal_.vertices.push_back({v, points_[v], kinds_[v], supports_[v], cell_of_[v], changed_[v]});
  }
  void note_cell(CellIndex c) {
    if (journal_.is_open && journal_.is_new_cell(c))
      journal_.cells.push_back(
          {c, mesh_.cells()[c], attributes_.component[c], attributes_.tags[c], attributes_.shape[c]});
  }
  void set_cell(CellIndex c, const NewCell& cell, std::uint64_t time);
  void set_shape(CellIndex c, double shape, std::uint64_t time);
  void note_curve(VertexIndex a, VertexIndex b) {
    if (journal_.is_open) journal_.curves.push_back({a, b, curves_.find({a, b})});
  }

  std::vector<VertexKind> kinds_;
  std::vector<Index> supports_;
  std::vector<std::uint64_t> changed_;
  std::vector<bool> pinched_;  // whether each imported vertex is non-manifold

  CellQuality measure_;
  std::uint64_t clock_ = 1;

  std::vector<Index> facet_patch_;
  std::vector<CurveClass> curve_classes_;
  EdgeMap curves_;

  MeshJournal journal_;
};

/// Returns whether a cell at one of the vertices was created, or a vertex of such a cell moved, after the given time.
template <class Vertices>
bool changed_since(const DomainMesh& mesh, const Vertices& vertices, std::uint64_t time) {
  return std::any_of(vertices.begin(), vertices.end(), [&](VertexIndex v) { return mesh.changed_at(v) > time; });
}

/// The cells of one component and the curves along their edges. Faces shared with other components are constrained and
/// have no neighbour in this mesh. Patches and curve classes remain those of the whole mesh.
struct MeshPart {
  DomainMesh mesh;
  std::vector<VertexIndex> vertices;  ///< numbers in the whole mesh of the vertices that the component had at first
};

}  // namespace geomesh::remesh
