// SPDX-License-Identifier: MIT
/// @file
/// The mesh that refinement and improvement work on: the editable mesh with several domains, the surfaces between them,
/// and curves, valid after every operation.
///
/// Invariants, beside those of EditableMesh (validate() checks each):
///   1. a face that is part of a facet carries that facet on both sides, `above` on one side and not on the other;
///   2. two cells of different components never share an untagged face, and a face without neighbour is tagged;
///   3. every registered curve edge is an edge of the mesh.
///
/// There is one operation that changes connectivity: `replace`. Every local operation (split, collapse, flip,
/// insertion) computes the two sets, checks each new cell with the exact predicate, and calls it: so no operation can
/// make crossings, and what is not admissible is refused before anything is changed.
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
#include "remesh/domain/star_links.hpp"

namespace geomesh::remesh {

/// Attributes of cells: component, tags of the faces, cached shape.
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
    else if (own.constrained())  // a surface that the operation has moved to the border
      tags[other.face.cell()][other.face.face()] = own.opposite();
  }

  /// Makes room for so many cells, whose attributes have to be set.
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

class DomainMesh : public EditableMesh<DomainAttributes> {
 public:
  // Vertices.
  std::size_t n_vertices() const { return points_.size(); }
  VertexKind kind(VertexIndex v) const { return kinds_[v]; }
  /// Patch of a surface vertex, curve class of a curve vertex, otherwise no_index.
  Index support(VertexIndex v) const { return supports_[v]; }
  CellIndex incident_cell(VertexIndex v) const { return cell_of(v); }
  VertexIndex add_vertex(const Vec3& p, VertexKind kind, Index support = no_index);
  /// The caller has checked that the cells about v stay positive. Their cached shapes are forgotten by refresh_shape.
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
  /// Normal of a face, of length twice its area.
  Vec3 normal(const Triangle& t) const { return triangle_normal(points_[t[0]], points_[t[1]], points_[t[2]]); }

  // Cells.
  /// The measure of shapes. To be set before the first cell.
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
  /// Counter-clockwise seen from the cell.
  Triangle face(FaceRef f) const { return face_of(vertices(f.cell()), f.face()); }
  Triangle face(CellIndex c, unsigned i) const { return face_of(vertices(c), i); }
  /// Counter-clockwise seen from above the facet.
  Triangle facet_face(FaceRef f) const {
    Triangle t = face(f);
    if (!tag(f).above()) std::swap(t[1], t[2]);
    return t;
  }
  /// Returns whether the face is constrained and seen from the side that represents both sides: above, or the only one.
  bool is_surface(FaceRef f) const {
    const FaceTag t = tag(f);
    return t.constrained() && (t.above() || !mesh_.mirror(f).valid());
  }
  /// visit(face) for each face that is part of a facet, once.
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
  /// Whether (f, apex) is a positive cell, exactly.
  bool sees(const Vec3& apex, const Triangle& f) const {
    return orient3d(points_[f[0]], points_[f[1]], points_[f[2]], apex) == Sign::positive;
  }
  bool is_positive(const Tetrahedron& t) const { return sees(points_[t[3]], {t[0], t[1], t[2]}); }
  /// Cached shape of a live cell.
  double shape_of(CellIndex c) const { return attributes_.shape[c]; }
  void refresh_shape(CellIndex c);
  /// Sets a shape that is known.
  void set_shape(CellIndex c, double shape);
  /// The mesh's time when a cell with the vertex was last made, or one of the vertices of such a cell moved.
  std::uint64_t changed_at(VertexIndex v) const { return changed_[v]; }
  /// Ends a moment and returns it: changes after the call are later than it, those before are not. Above 0.
  std::uint64_t tick() { return clock_++; }
  bool has_neighbor(CellIndex c, unsigned face) const { return mesh_.neighbor(c, face).valid(); }

  /// Exchanges the removed cells for the added ones, which must fill the same region and be positive. Faces on the
  /// region's border keep their tags and neighbours. Returns the new cells in `created` (in the order of `added`). O(k
  /// log k). Throws InternalError where the two regions do not have the same border.
  void replace(std::span<const CellIndex> removed, std::span<const NewCell> added, std::vector<CellIndex>& created);
  /// Replaces cells of a block, concurrently with changes of other blocks. The caller has checked that it may.
  void replace(std::span<const CellIndex> removed, std::span<const NewCell> added, std::vector<CellIndex>& created,
               BlockEdit& block);
  /// Replaces cells of one component without constrained faces inside by the star of `apex`: a cell for each face of
  /// their border, in this order, with the `shapes`, of which there may be more. O(k).
  void replace_by_star(std::span<const CellIndex> removed, std::span<const StarFace> border, VertexIndex apex,
                       std::span<const double> shapes, std::vector<CellIndex>& created);
  /// The vertex must be in no live cell.
  void remove_vertex(VertexIndex v);

  /// @name Blocks (mesh_blocks.hpp)
  /// @{
  /// A clock and free slots for a block: to be called for all before any is worked on.
  void open_block(BlockEdit& block, std::size_t n_slots);
  /// Must be called for all blocks once they have been processed.
  void close_block(BlockEdit& block);
  /// @}

  /// @name Components on their own
  /// What changes inside of components alone can so be done in all of them at once.
  /// @{
  /// The components that have cells, in ascending order. This mesh is then without cells. O(n).
  std::vector<MeshPart> take_apart();
  /// Takes the parts in again, in their order: their cells, and the vertices that they did not begin with. Faces to
  /// other components must be as they were. O(n), and n log n in such faces.
  void put_together(std::vector<MeshPart> parts, unsigned threads = 1);
  /// @}

  /// Renumbers the cells along a curve that fills space, so that near ones are near in memory. No slot is free after
  /// it. O(n log n).
  void sort_cells(unsigned threads = 1);
  /// Vertices in the order of the first cell that has them: near ones one after the other where cells are sorted.
  std::vector<VertexIndex> vertices_by_cells() const;

  // Patches and curves.
  Index patch_of_facet(Index facet) const { return facet == hull_facet ? hull_patch : facet_patch_[facet]; }
  Index patch_of(FaceTag t) const { return patch_of_facet(t.facet()); }
  void set_facet_patches(std::vector<Index> patches) { facet_patch_ = std::move(patches); }
  std::size_t n_patches() const;
  const CurveClass& curve_class(Index c) const { return curve_classes_[c]; }
  Index add_curve_class(CurveClass c);
  std::size_t n_curve_classes() const { return curve_classes_.size(); }
  /// Class of the curve edge a-b, or no_index.
  Index curve_of(VertexIndex a, VertexIndex b) const {
    const bool possible = kinds_[a] <= VertexKind::curve && kinds_[b] <= VertexKind::curve;
    return possible ? curves_.find({a, b}) : no_index;
  }
  /// @name Where the outside passes through.
  /// Cells may meet at a vertex, or at an edge, that no sequence of faces at it joins, because the outside is between
  /// them. `star` and `edge_ring` find only those joined with the cell they start from. So such a vertex, or a vertex
  /// of such an edge, is a corner; `is_pinched` returns it. A curve's edge between two of them is not split.
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
  /// Curve edges in ascending order of their vertices.
  std::vector<std::array<VertexIndex, 2>> curve_edges() const { return curves_.sorted_keys(); }

  /// @name A trial: changes that can be undone
  /// One at a time, by one thread; link_cells, reserve and new patches or curve classes are no part of it.
  /// @{
  void begin_trial();
  void keep_trial() { journal_.is_open = false; }
  /// Restores the state in which the trial began, including the order of free slots and the mesh's time. O(changes).
  void undo_trial();
  /// Cells that were made, changed or removed since the trial began.
  template <class Visit>
  void for_each_trial_cell(const Visit& visit) const {
    for (const SavedCell& s : journal_.cells) visit(s.cell);
    for (CellIndex c = journal_.n_slots; c < n_slots(); ++c) visit(c);
  }
  /// Calls visit for the live cells among these that have changed. Cells of which only a neighbour was exchanged have
  /// not.
  template <class Visit>
  void for_each_cell_of_trial(const Visit& visit) const {
    for (const SavedCell& s : journal_.cells)
      if (is_live(s.cell) && (vertices(s.cell) != s.links.vertices || shape_of(s.cell) != s.shape)) visit(s.cell);
    for (CellIndex c = journal_.n_slots; c < n_slots(); ++c)
      if (is_live(c)) visit(c);
  }
  /// Vertices that were made, moved, changed or removed, and those of cells that were.
  template <class Visit>
  void for_each_trial_vertex(const Visit& visit) const {
    for (const SavedVertex& s : journal_.vertices) visit(s.vertex);
    for (auto v = static_cast<VertexIndex>(journal_.n_vertices); v < n_vertices(); ++v) visit(v);
  }
  /// visit(shape) for each cell that the trial changed or removed, with the shape that it had.
  template <class Visit>
  void for_each_cell_before_trial(const Visit& visit) const {
    for (const SavedCell& s : journal_.cells)
      if (s.links.vertices[0] != no_vertex) visit(s.shape);
  }
  /// @}

  // Building (import): cells first, then link_cells, then tags.
  CellIndex add_cell(const Tetrahedron& vertices, Index component, double shape = NewCell::unknown_shape);
  void link_cells();
  void set_tag(CellIndex c, unsigned face, FaceTag t) {
    note_cell(c);
    attributes_.tags[c][face] = t;
  }
  void reserve(std::size_t n_vertices, std::size_t n_cells);

  /// Checks the invariants; the first violation is described in the string returned, empty where all hold. O(n log n).
  std::string validate(unsigned threads = 1) const;

 private:
  void fill_part(const std::vector<CellIndex>& cells, const std::vector<CellIndex>& row_of_cell,
                 std::vector<VertexIndex>& row, MeshPart& part) const;
  using OpenFace = std::pair<FaceKey, FaceRef>;
  struct CellCopies;
  void copy_cell(const CellCopies& from, CellIndex c, std::vector<OpenFace>& open);
  void append(MeshPart part, unsigned threads, std::vector<OpenFace>& open);
  /// Links equal faces with each other.
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
  std::vector<bool> pinched_;  // by vertex, of those there were at first

  CellQuality measure_;
  std::uint64_t clock_ = 1;

  std::vector<Index> facet_patch_;
  std::vector<CurveClass> curve_classes_;
  EdgeMap curves_;

  MeshJournal journal_;
  StarLinks star_links_;
  std::vector<FaceTag> border_tags_;  // scratch
};

/// Returns whether a cell at one of the vertices was made, or has moved, since that time of the mesh.
template <class Vertices>
bool changed_since(const DomainMesh& mesh, const Vertices& vertices, std::uint64_t time) {
  return std::any_of(vertices.begin(), vertices.end(), [&](VertexIndex v) { return mesh.changed_at(v) > time; });
}

/// The cells of one component, with the curves that run along their edges. Faces to other components are constrained
/// and have no neighbour. Patches and classes of curves are those of the whole, which alone knows them.
struct MeshPart {
  DomainMesh mesh;
  std::vector<VertexIndex> vertices;  ///< rows in the whole, of the part's first vertices: those that it began with
};

}  // namespace geomesh::remesh
