// SPDX-License-Identifier: MIT
/// @file
/// A patch of coplanar triangles. Finds the loops of its outline, and the triangle that contains a given point.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "delaunay/plane_space.hpp"
#include "geomesh/core/geometry.hpp"
#include "geomesh/core/predicates.hpp"
#include "plc/facet_triangulation.hpp"

namespace geomesh {

/// Exactly coplanar triangles connected by edges, oriented like the first. Corner 3 t + k is vertex k of triangle t.
class FlatPatch {
 public:
  using Edge = std::array<VertexIndex, 2>;

  /// Makes a patch. Returns nothing if an edge has more than two triangles, or two on one side of it, or if rounding
  /// leaves no axis along which the plane can be projected. `points` must outlive the patch.
  static std::optional<FlatPatch> of(std::span<const Vec3> points, std::vector<Triangle> triangles);

  /// Returns whether a triangle of the patch was reversed, so that all triangles have the orientation of the first.
  bool is_turned(Index triangle) const { return is_turned_[triangle]; }
  Index n_triangles() const { return static_cast<Index>(triangles_.size()); }
  /// Returns the vertices of triangle t of the patch, in the orientation that all its triangles have in common.
  const Triangle& triangle(Index t) const { return triangles_[t]; }
  VertexIndex vertex(Index corner) const { return triangles_[corner / 3][corner % 3]; }
  /// Returns the corner at which the edge that begins at `corner` begins, reversed, in the adjacent triangle; no_index
  /// if the edge is on the border of the patch.
  Index opposite(Index corner) const { return opposite_[corner]; }
  /// Returns positive if the vertices a, b, c have the same orientation as the triangles of the patch.
  Sign turn(VertexIndex a, VertexIndex b, VertexIndex c) const { return turn(a, b, points_[c]); }
  Sign turn(VertexIndex a, VertexIndex b, const Vec3& c) const { return orient2d(flat(a), flat(b), projection_(c)); }
  /// Returns the patch as one polygon: the outer loop and the holes, with the patch on their left; the given segments;
  /// and the inner vertices that are not on segments. O(n log n).
  FacetPolygon polygon(std::vector<Edge> segments) const;

  /// Returns the triangle that contains the centroid (rounded to doubles) of a triangle inside the patch, whose
  /// vertices are points of the patch or on it. Exact for the rounded centroid. `near` lists the corners of the
  /// triangle that are vertices of the patch, if any. O(triangles from a corner to the centroid), O(n) without one.
  Index triangle_at_centroid(const std::array<Vec3, 3>& corners, std::span<const VertexIndex> near) const;

 private:
  FlatPatch(std::span<const Vec3> points, std::vector<Triangle> triangles)
      : points_(points), triangles_(std::move(triangles)) {}

  bool project();
  bool join();
  void sort_corners();
  static Index next(Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  Vec2 flat(VertexIndex v) const { return projection_(points_[v]); }
  /// Returns the next edge of the border, found by turning around the end of `corner`'s edge through the patch.
  Index next_on_border(Index corner) const;
  std::vector<std::vector<VertexIndex>> loops() const;
  std::span<const Index> corners_at(VertexIndex v) const;
  bool holds(Index triangle, const Vec2& x) const;
  double distance_outside(Index triangle, const Vec2& x) const;
  std::optional<Index> walk_from(VertexIndex v, const Vec2& x) const;

  std::span<const Vec3> points_;
  std::vector<Triangle> triangles_;
  std::vector<bool> is_turned_;
  PlaneProjection projection_;
  std::vector<Index> opposite_;  ///< by corner
  std::vector<Index> corners_;   ///< sorted by vertex
};

}  // namespace geomesh
