// SPDX-License-Identifier: MIT
/// @file
/// The constrained Delaunay triangulation of points in a plane: a 2D Delaunay triangulation in which segments are
/// recovered by flips (Sloan 1993). It makes the draft of a facet (Cavalcanti and Mello 1999, section 3.2).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "common/flat_map.hpp"
#include "delaunay/cavity_insertion.hpp"
#include "delaunay/plane_space.hpp"

namespace geomesh {

/// Holds the mesh and the points, to which the other base class of ConstrainedTriangulation has references.
struct PlaneStore {
  TriMesh mesh;
  std::vector<PointRecord> records;  ///< the points by index, followed by the infinite vertex
};

/// Vertices are indices of the given points. Orientations are those of the projection.
class ConstrainedTriangulation : private PlaneStore, private CavityInsertion<PlaneSpace> {
 public:
  using Edge = std::array<VertexIndex, 2>;
  /// An obstacle to a permanent edge: a vertex on the edge, or the two ends of a permanent edge that crosses it.
  using Obstacle = std::vector<VertexIndex>;

  /// The points must be exactly in one plane that is not parallel to the axis of projection.
  ConstrainedTriangulation(std::span<const Vec3> points, PlaneProjection projection);
  ConstrainedTriangulation(const ConstrainedTriangulation&) = delete;
  ConstrainedTriangulation& operator=(const ConstrainedTriangulation&) = delete;

  /// Makes the Delaunay triangulation of all points. Returns false if all are collinear or two are equal. O(n log n).
  bool triangulate();
  /// Makes a-b a permanent edge by flips. Returns an obstacle if that is not possible.
  std::optional<Obstacle> insert_constraint(VertexIndex a, VertexIndex b);
  /// Returns the number of edges that a-b crosses, up to `most`; 0 if a-b is an edge or runs through a vertex.
  std::size_t n_crossed(VertexIndex a, VertexIndex b, std::size_t most) const;
  /// Restores the Delaunay criterion for all edges that are not constraints.
  void restore_delaunay();
  /// Returns the apex of the triangle on the left of edge a-b; nothing if there is no such edge or triangle.
  std::optional<VertexIndex> apex(VertexIndex a, VertexIndex b) const;
  /// Returns the triangles that are reached from the left of the edges `from` without crossing an edge of `barriers`.
  std::vector<Triangle> triangles_left_of(std::vector<Edge> from, std::span<const Edge> barriers) const;

 private:
  using Insertion = CavityInsertion<PlaneSpace>;

  bool start_with_a_triangle(std::vector<VertexIndex>& order);
  FaceRef edge(VertexIndex a, VertexIndex b) const;
  Sign orient(VertexIndex a, VertexIndex b, VertexIndex c) const { return space().orient(a, b, c); }
  bool is_constraint(VertexIndex a, VertexIndex b) const { return constraints_.find({a, b}) != no_index; }
  bool is_flippable(VertexIndex a, VertexIndex b) const;
  void flip(VertexIndex a, VertexIndex b);
  std::variant<FaceRef, Obstacle> exit_from_star(VertexIndex a, VertexIndex b) const;
  /// Calls `visit` with each edge that the segment a-b crosses, as long as `visit` returns true. The end of the edge on
  /// the right of a-b comes first. If an obstacle is returned, the edges before it have been visited.
  template <class Visit>
  std::optional<Obstacle> cross_edges(VertexIndex a, VertexIndex b, const Visit& visit) const;

  std::vector<CellIndex> cell_of_;
  EdgeMap constraints_;
};

}  // namespace geomesh
