// SPDX-License-Identifier: MIT
/// @file
/// The mesh that refinement and improvement work on: several domains, the surfaces between them, and curves, valid after every
/// operation.
///
/// Invariants (validate() checks each):
///   1. every live cell is exactly positive; neighbour links are mutual and see their face with opposite orientations;
///   2. a face that is part of a facet carries that facet on both sides, `above` on one side and not on the other;
///   3. two cells of different components never share an untagged face, and a face without neighbour is tagged;
///   4. every registered curve edge is an edge of the mesh;
///   5. incident_cell(v) of a live vertex is a live cell that has v.
///
/// There is one operation that changes connectivity: `replace`, which exchanges a set of cells for another that fills the same
/// region. Every local operation (split, collapse, flip, insertion) computes the two sets, checks each new cell with the exact
/// predicate, and calls it: so no operation can make crossings, and what is not admissible is refused before anything is changed.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "refine/curve_edges.hpp"

namespace geomesh::remesh {

/// Which facet a mesh face is part of, and on which of the facet's sides the cell lies that the face is seen from.
class FaceTag {
 public:
  constexpr FaceTag() = default;
  constexpr FaceTag(Index facet, bool above) : code_(2 * facet + (above ? 1u : 0u)) {}
  constexpr bool constrained() const { return code_ != none; }
  constexpr Index facet() const { return code_ >> 1; }
  constexpr bool above() const { return (code_ & 1u) != 0; }  ///< the cell is on the side that the facet's normal points to
  constexpr FaceTag opposite() const { return constrained() ? FaceTag(facet(), !above()) : *this; }
  friend constexpr bool operator==(FaceTag, FaceTag) = default;

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  std::uint32_t code_ = none;
};

/// Stands for the facet of a boundary face that is part of none. Never moved.
inline constexpr Index hull_facet = 0x7FFFFFFEu;
inline constexpr Index hull_patch = 0x7FFFFFFEu;

/// How free a vertex is to move or go.
enum class VertexKind : std::uint8_t {
  corner,   ///< stays: ends and junctions of curves, isolated points, in `exact` every input vertex
  curve,    ///< along its curve
  surface,  ///< within its patch
  inside,   ///< freely
  dead,     ///< removed
};

/// A curve edge's class: edges are of one curve where the same segments and the same patches meet in them.
struct CurveClass {
  std::vector<Index> segments;  ///< rows in plc.segments, ascending
  std::vector<Index> patches;   ///< ascending, a patch twice where it passes through
  friend bool operator==(const CurveClass&, const CurveClass&) = default;
};

struct NewCell {
  Tetrahedron vertices;
  Index component = 0;
  std::array<FaceTag, 4> tags{};  ///< of faces inside the region that are constrained; those on its border are inherited
  double shape = unknown_shape;   ///< where it has been computed already, of the vertices in this order
  static constexpr double unknown_shape = -1;
};

/// Marks on cells by epoch, so that clearing costs nothing. One a thread.
class CellMarks {
 public:
  void begin(std::size_t n_slots) {
    if (stamp_.size() < n_slots) stamp_.resize(n_slots + n_slots / 4, 0);
    ++epoch_;
  }
  bool marked(CellIndex c) const { return c < stamp_.size() && stamp_[c] == epoch_; }
  void mark(CellIndex c) { stamp_[c] = epoch_; }
  void unmark(CellIndex c) { stamp_[c] = 0; }

 private:
  std::vector<std::uint32_t> stamp_;
  std::uint32_t epoch_ = 0;
};

class DomainMesh {
 public:
  // Vertices.
  std::size_t n_vertices() const { return points_.size(); }
  const Vec3& point(VertexIndex v) const { return points_[v]; }
  VertexKind kind(VertexIndex v) const { return kinds_[v]; }
  /// Patch of a surface vertex, curve class of a curve vertex, else no_index.
  Index support(VertexIndex v) const { return supports_[v]; }
  CellIndex incident_cell(VertexIndex v) const { return incident_[v]; }
  VertexIndex add_vertex(const Vec3& p, VertexKind kind, Index support = no_index);
  /// The caller has checked that the cells about v stay positive. Their cached shapes are forgotten by refresh_shape.
  void move_vertex(VertexIndex v, const Vec3& p) { points_[v] = p; }
  void set_kind(VertexIndex v, VertexKind kind, Index support) { kinds_[v] = kind, supports_[v] = support; }

  // Cells.
  const TetMesh& topology() const { return mesh_; }
  CellIndex n_slots() const { return mesh_.n_slots(); }
  std::size_t n_cells() const { return mesh_.n_live(); }
  bool is_live(CellIndex c) const { return mesh_.is_live(c); }
  const Tetrahedron& vertices(CellIndex c) const { return mesh_.vertices(c); }
  Index component(CellIndex c) const { return component_[c]; }
  FaceTag tag(CellIndex c, unsigned face) const { return tags_[c][face]; }
  /// Cached shape of a live cell.
  double shape_of(CellIndex c) const { return shape_[c]; }
  void refresh_shape(CellIndex c);
  /// The same where the shape is known.
  void set_shape(CellIndex c, double shape);
  /// The mesh's time when a cell with the vertex was last made, or one of the vertices of such a cell moved.
  std::uint64_t changed_at(VertexIndex v) const { return changed_[v]; }
  /// Ends a moment and returns it: changes after the call are later than it, those before are not. Above 0.
  std::uint64_t tick() { return clock_++; }
  bool has_neighbor(CellIndex c, unsigned face) const { return mesh_.neighbor(c, face).valid(); }

  /// Exchanges the removed cells for the added ones, which must fill the same region and be positive. Faces on the region's
  /// border keep their tags and neighbours. Returns the new cells in `created` (in the order of `added`). O(k log k). Throws
  /// InternalError where the two regions do not have the same border.
  void replace(std::span<const CellIndex> removed, std::span<const NewCell> added, std::vector<CellIndex>& created);
  /// The vertex must be in no live cell.
  void remove_vertex(VertexIndex v);

  /// Cells about v, in an order that depends on the mesh alone.
  void star(VertexIndex v, CellMarks& marks, std::vector<CellIndex>& cells) const;

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
    return possible ? curves_.find(a, b) : no_index;
  }
  void set_curve(VertexIndex a, VertexIndex b, Index curve_class) { curves_.set(a, b, curve_class); }
  void erase_curve(VertexIndex a, VertexIndex b) { curves_.erase(a, b); }
  /// Curve edges in ascending order of their vertices.
  std::vector<std::array<VertexIndex, 2>> curve_edges() const { return curves_.sorted(); }

  // Building (import): cells first, then link_cells, then tags.
  CellIndex add_cell(const Tetrahedron& vertices, Index component, double shape = NewCell::unknown_shape);
  void link_cells();
  void set_tag(CellIndex c, unsigned face, FaceTag t) { tags_[c][face] = t; }
  void reserve(std::size_t n_vertices, std::size_t n_cells);

  /// Checks the invariants; the first violation is described in the string returned, empty where all hold. O(n log n).
  std::string validate() const;

 private:
  /// Vertices of a face in ascending order, packed so that comparing is cheap.
  struct FaceKey {
    std::uint64_t low_and_middle;
    VertexIndex high;
    friend bool operator==(const FaceKey&, const FaceKey&) = default;
    bool operator<(const FaceKey& o) const { return low_and_middle != o.low_and_middle ? low_and_middle < o.low_and_middle : high < o.high; }
  };
  struct FaceRecord {
    FaceKey key;
    FaceRef face;  // outer neighbour, or the new face
    FaceTag tag;   // seen from the new side
    bool outer;
  };
  /// The records of one face.
  struct FaceGroup {
    const FaceRecord* outer = nullptr;  // the last of them
    std::array<const FaceRecord*, 2> added{};
    unsigned n_outer = 0, n_added = 0;
    bool is_empty() const { return n_outer + n_added == 0; }
    const FaceKey& key() const { return n_outer > 0 ? outer->key : added[0]->key; }
    void take(const FaceRecord& record);
  };
  static FaceKey face_key(const Tetrahedron& t, unsigned i);
  void collect_border(std::span<const CellIndex> removed, std::vector<FaceRecord>& records) const;
  void settle(const FaceGroup& group);
  /// Links and tags the faces of the new cells. By sorting: O(n log n).
  void pair_faces(std::vector<FaceRecord>& records);
  /// The same in a table that is kept from call to call. O(n).
  void pair_few_faces(std::span<const FaceRecord> records);

  std::vector<Vec3> points_;
  std::vector<VertexKind> kinds_;
  std::vector<Index> supports_;
  std::vector<CellIndex> incident_;
  std::vector<std::uint64_t> changed_;

  TetMesh mesh_;
  std::vector<Index> component_;
  std::vector<std::array<FaceTag, 4>> tags_;
  std::vector<double> shape_;
  std::uint64_t clock_ = 1;

  std::vector<Index> facet_patch_;
  std::vector<CurveClass> curve_classes_;
  CurveEdges curves_;

  std::vector<FaceRecord> records_;  // scratch of replace, as are the next two
  std::vector<FaceGroup> slots_;     // all empty between calls
  std::vector<std::size_t> used_slots_;
};

}  // namespace geomesh::remesh
