// SPDX-License-Identifier: MIT
/// @file
/// The constrained Delaunay triangulation of points in a plane: the 2D child of the Delaunay base, then segments
/// recovered by flips (Sloan 1993). Small, for facets; the paper's draft (section 3.2) is made by it.
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

/// Mesh and points, which the base holds by reference.
struct PlaneStore {
  TriMesh mesh;
  std::vector<PointRecord> records;  ///< by row, then the one at infinity
};

/// Vertices are rows of the points given. Orientations are those of the projection.
class ConstrainedTriangulation : private PlaneStore, private CavityInsertion<PlaneSpace> {
 public:
  using Edge = std::array<VertexIndex, 2>;
  /// What stands in the way of a constraint: a vertex on it, or a constraint that it crosses.
  using Obstacle = std::vector<VertexIndex>;

  /// Of points exactly in one plane, to which the axis dropped is not parallel.
  ConstrainedTriangulation(std::span<const Vec3> points, PlaneProjection projection);
  ConstrainedTriangulation(const ConstrainedTriangulation&) = delete;
  ConstrainedTriangulation& operator=(const ConstrainedTriangulation&) = delete;

  /// Delaunay triangulation of all points. False where all are collinear or two are equal. O(n log n).
  bool triangulate();
  /// Makes a-b an edge for good, by flips. An obstacle: not done.
  std::optional<Obstacle> insert_constraint(VertexIndex a, VertexIndex b);
  /// Number of edges that a-b crosses, counted up to `most`; 0 where it is an edge or runs through a vertex.
  std::size_t n_crossed(VertexIndex a, VertexIndex b, std::size_t most) const;
  /// The Delaunay criterion for all edges that are no constraints.
  void restore_delaunay();
  /// Vertex of the triangle on the left of a-b, nothing where there is no such edge or the outside is there.
  std::optional<VertexIndex> apex(VertexIndex a, VertexIndex b) const;
  /// The triangles that are reached from the left of the edges `from` without crossing one of `barriers`.
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
  /// Shows `visit` each edge that a-b crosses, its end on the right of a-b first, while it returns true. An obstacle:
  /// it has been shown what is before it.
  template <class Visit>
  std::optional<Obstacle> cross_edges(VertexIndex a, VertexIndex b, const Visit& visit) const;

  std::vector<CellIndex> cell_of_;
  EdgeMap constraints_;
};

}  // namespace geomesh
