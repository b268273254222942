// SPDX-License-Identifier: MIT
/// @file
/// Recovers constraints without adding points: a cavity is emptied and filled anew, with the constraint as triangles
/// inside it (the cavities of Shewchuk 2002 and of Si and Gaertner 2011, filled by search instead of by gift
/// wrapping, because the mesh is not Delaunay).
#pragma once

#include "recover/model/recover.hpp"
#include "recover/model/recovery_budget.hpp"
#include "recover/operations/polyhedron_filling.hpp"

namespace geomesh::recover {

struct CavityEffort {
  std::size_t max_nodes = recovery_budget.filling_nodes;
  std::size_t max_faces = recovery_budget.filling_faces;
};

/// Cells to be replaced. They surround no subsegment, locked face or vertex, except a vertex that is to be removed.
class Cavity {
 public:
  /// `cells`, without duplicates, are to be replaced. `dropped` is one of their vertices, to be removed from the mesh,
  /// or no_vertex. Faces with this vertex are not part of the cavity's boundary, so the caller must close the gaps by
  /// triangles (add_sheet). `is_valid()`: whether the cavity may be emptied. O(n log n) for n cells.
  Cavity(const Recovery& recovery, std::vector<CellIndex> cells, VertexIndex dropped = no_vertex);

  /// Adds a triangle in the cavity that must be a face of a new cell, on the side where it is counter-clockwise.
  void add_sheet(const Triangle& t) { boundary_.push_back({t, {}}); }
  /// Sets the cells, in ascending order, into which the cavity must not grow.
  void forbid(std::vector<CellIndex> cells) { forbidden_ = std::move(cells); }

  bool is_valid() const;
  std::vector<Triangle> boundary() const;
  const std::vector<CellIndex>& cells() const { return cells_; }
  bool has_edge(VertexIndex a, VertexIndex b) const;
  /// Returns the vertices connected with v by an edge of the cavity's boundary, sorted.
  std::vector<VertexIndex> neighbors(VertexIndex v) const;

  /// Returns cells that connect all boundary faces of the cavity with y, a point that no cell has yet. The cavity,
  /// which must be valid, grows across faces that are not visible from y.
  std::optional<std::vector<Tetrahedron>> star_from(VertexIndex y, unsigned max_growths);
  std::optional<std::vector<Tetrahedron>> fill(const CavityEffort& effort) const;

 private:
  struct BoundaryFace {
    Triangle triangle;  ///< corners of a face of the cavity's boundary, counter-clockwise as seen from inside
    FaceRef inner;      ///< the boundary face in its cell in the cavity; invalid for a triangle added by add_sheet()
  };

  bool may_grow_over(const BoundaryFace& side) const;
  bool grow_over(FaceRef face);
  bool swallows_constraint(const std::vector<BoundaryFace>& before) const;
  bool is_of_dropped(FaceRef face) const;
  void add_side(FaceRef face);
  void add_cell(CellIndex c);
  bool contains(CellIndex c) const { return std::find(cells_.begin(), cells_.end(), c) != cells_.end(); }

  const Recovery& recovery_;
  std::vector<CellIndex> cells_;
  std::vector<BoundaryFace> boundary_;
  std::vector<CellIndex> forbidden_;
  VertexIndex dropped_;
};

/// Makes a-b an edge of the mesh, as a side of a triangle a,b,c whose vertex c is already connected with both ends.
bool recover_segment_by_cavity(Recovery& recovery, VertexIndex a, VertexIndex b, const CavityEffort& effort);

/// Makes the triangle t, whose edges must be present, a face. `pierced` are the cells around the edges that pierce it.
bool recover_face_by_cavity(Recovery& recovery, const Triangle& t, std::vector<CellIndex> pierced,
                            const CavityEffort& effort);

}  // namespace geomesh::recover
