// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Constrained triangulation in the plane of one facet, or of a cluster of overlapping coplanar facets, over exact
/// points.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <vector>

#include "arrangement/model/complex.hpp"
#include "arrangement/model/contacts.hpp"
#include "arrangement/model/exact_point.hpp"

namespace geomesh::geomodel::arrangement {

/// A point of the plane: its nearest doubles, and its exact place if these are not exact.
struct PlanarPoint {
  Vec3 rounded;
  const ExactPoint* exact = nullptr;
};

/// Incremental triangulation with constraint insertion by flips (Sloan 1993, "A fast algorithm for generating
/// constrained Delaunay triangulations"). All decisions that affect validity are exact orientations. The Delaunay
/// property is not required: flips for quality use rounded angles, which keeps slivers away and costs no exact
/// in-circle test. A new point is made where constraints cross. Invariants: triangles are counter-clockwise in the
/// projection; neighbours are mutual; a constrained edge is never flipped away.
class PlanarTriangulation {
 public:
  static constexpr int none = -1;
  struct Face {
    /// Edge i of a face is opposite v[i].
    std::array<int, 3> v, neighbour{none, none, none}, constraint{none, none, none};
  };
  /// Makes the point where the lines of two constraints cross, which the triangulation then adds to itself.
  using Crossing = std::function<PlanarPoint(int line_a, int line_b)>;

  PlanarTriangulation(const ExactFrame& frame, std::size_t i, std::size_t j, Crossing crossing)
      : frame_(frame), i_(i), j_(j), crossing_(std::move(crossing)) {}

  int add_point(const PlanarPoint& p);
  /// Creates the triangulation's first face, which must be counter-clockwise and contain every later point.
  void start(int a, int b, int c);
  void insert_point(int p);
  /// Makes the segment a union of constrained edges with the label `line`.
  void insert_constraint(int a, int b, int line);
  /// Constrains edges of the triangulation's first face; to be called before anything else is inserted.
  void constrain_border(const std::array<int, 3>& lines) { faces_[0].constraint = lines; }

  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<PlanarPoint>& points() const { return points_; }
  Sign orient(int a, int b, int c) const;
  /// Returns the triangulation's vertices on the way from a to b along existing edges.
  std::vector<int> chain(int a, int b) const;
  /// Returns the face to the left of edge ab and the edge's index in that face; {none, none} on the border.
  std::pair<int, int> left_face(int a, int b) const;

 private:
  enum class Place { inside, on_edge, on_vertex };
  struct Stop {
    int vertex = none;
    bool is_edge = false;  ///< whether an edge from a to `vertex` exists
    /// The face at vertex a that the segment crosses, and its edge opposite a, if no edge at a runs along the segment.
    int face = none, edge = none;
  };
  Place locate(int p, int& face, int& index) const;
  void split_face(int face, int p);
  void split_edge(int face, int edge, int p);
  void flip(int face, int edge);
  void legalize(std::vector<std::pair<int, int>>& edges);
  bool wants_flip(int face, int edge) const;
  bool is_convex(int face, int edge) const;
  Stop first_stop(int a, int b) const;
  int advance(int a, int b, int line);
  void force_edge(int a, int b, std::vector<std::pair<int, int>>& crossed);
  void mark(int a, int b, int line);
  template <typename Visit>
  void star(int a, Visit&& visit) const;
  void touch(int face);
  int index_of(int face, int v) const;
  int mirror(int face, int edge) const;
  ExactPoint exact(int p) const;

  const ExactFrame& frame_;
  std::size_t i_, j_;
  Crossing crossing_;
  std::vector<PlanarPoint> points_;
  std::vector<Face> faces_;
  std::vector<int> face_of_;  ///< for each point: a face of the triangulation at it; none before its insertion
  mutable int hint_ = 0;
  mutable unsigned turn_ = 0;
};

}  // namespace geomesh::geomodel::arrangement
