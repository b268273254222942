// SPDX-License-Identifier: MIT
/// @file
/// The flip algorithm of Joe (1991; Cavalcanti and Mello 1999, section 2.1): split the cells that contain the new
/// point, then flip link faces until all are locally Delaunay. Edelsbrunner and Shah (1996) prove that this always
/// succeeds when a point is inserted.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "delaunay/incremental.hpp"
#include "delaunay/space3.hpp"
#include "mesh/face_pairing.hpp"

namespace geomesh {

/// The vertex at infinity takes part in flips like any other: hull faces need no special case. A 4-4 flip with an
/// infinite vertex is the 2-2 flip of two coplanar hull faces. A 3-2 flip around an edge to infinity removes a vertex
/// from the hull.
class FlipInsertion : public IncrementalTriangulation<Space3, false> {
 public:
  using IncrementalTriangulation::IncrementalTriangulation;

  /// Inserts vertex v. A point closer than `cluster_distance` to a vertex of the cell that contains it is not inserted.
  InsertionOutcome insert(VertexIndex v, double cluster_distance = 0);
  /// Splits the cells that contain v without flips, so that the result need not be Delaunay.
  InsertionOutcome split_only(VertexIndex v);
  /// Flips all faces of the mesh that are not locally Delaunay and can be flipped. Returns the number of faces that
  /// remain not locally Delaunay (stuck). Each flip lowers the lifted surface, so this terminates.
  std::size_t flip_all();

  /// Makes the first possible of the flips 3-2, 2-3 and 4-4 at face f between two finite cells, whether or not the face
  /// is locally Delaunay. Returns false if none is possible. (At ghosts, orientations alone would allow a flip that
  /// dents the hull; the conflict test of the other functions keeps it convex.)
  bool flip_face(FaceRef f);

  std::size_t stuck_faces() const { return stuck_; }
  std::size_t flips() const { return flips_; }

 private:
  /// A face of a cell as it was when it was queued; the cell may have been removed since.
  struct Candidate {
    CellIndex cell;
    CellVertices vertices;
    unsigned face;
  };

  void collect_holders(CellIndex c, const Vec3& p);
  void flip_link(VertexIndex v);
  std::size_t flip_queue(VertexIndex v);
  bool is_current(const Candidate& q) const { return cells_[q.cell].vertices == q.vertices; }
  bool locally_delaunay(FaceRef f);
  bool try_flip(FaceRef f);
  bool try_3_to_2(FaceRef f, FaceRef outer);
  bool try_2_to_3(FaceRef f, FaceRef outer);
  bool try_4_to_4(FaceRef f, FaceRef outer);
  bool positive(const CellVertices& v);
  bool all_positive();
  bool adjacent(CellIndex c, VertexIndex a, VertexIndex b);
  bool has_infinite(const CellVertices& v) const { return is_ghost(v); }
  void replace();
  unsigned index_of(CellIndex c, VertexIndex v) const { return mesh_.index_of(c, v); }

  std::vector<CellIndex> old_;     ///< cells that a flip or a split replaces
  std::vector<CellVertices> new_;  ///< cells that replace old_; after replace() their slots are in made_
  std::vector<CellIndex> made_;
  std::vector<Candidate> queue_;
  std::size_t stuck_ = 0, flips_ = 0;
  FacePairing<bool> pairing_;
};

}  // namespace geomesh
