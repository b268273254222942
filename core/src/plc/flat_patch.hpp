// SPDX-License-Identifier: MIT
/// @file
/// A patch of coplanar triangles: its outline as loops, and the triangle in which a point of it lies.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "delaunay/plane_space.hpp"
#include "geomesh/core/geometry.hpp"
#include "geomesh/core/predicates.hpp"
#include "plc/facet_triangulation.hpp"

namespace geomesh {

/// Exactly coplanar triangles that are joined by edges. They are turned to run like the first one; corner 3 t + k is
/// vertex k of triangle t.
class FlatPatch {
 public:
  using Edge = std::array<VertexIndex, 2>;

  /// Returns nothing where an edge has more than two triangles, or two on one side of it. It returns nothing either
  /// where rounding leaves no axis along which the plane can be projected. `points` must outlive the patch.
  static std::optional<FlatPatch> of(std::span<const Vec3> points, std::vector<Triangle> triangles);

  /// Whether the given triangle runs against the first one.
  bool is_turned(Index triangle) const { return is_turned_[triangle]; }
  Index n_triangles() const { return static_cast<Index>(triangles_.size()); }
  /// As it is turned.
  const Triangle& triangle(Index t) const { return triangles_[t]; }
  VertexIndex vertex(Index corner) const { return triangles_[corner / 3][corner % 3]; }
  /// Corner from which the edge that begins at `corner` runs the other way, or no_index on the border.
  Index opposite(Index corner) const { return opposite_[corner]; }
  /// Positive where a, b, c turn as the triangles do.
  Sign turn(VertexIndex a, VertexIndex b, VertexIndex c) const { return turn(a, b, points_[c]); }
  Sign turn(VertexIndex a, VertexIndex b, const Vec3& c) const { return orient2d(flat(a), flat(b), projection_(c)); }
  /// Outer loop and holes, with the patch on the left; its vertices inside, apart from those on `segments`, which
  /// become segments of the polygon. O(n log n).
  FacetPolygon polygon(std::vector<Edge> segments) const;

  /// The triangle that holds the centroid (rounded to doubles) of a triangle inside the patch, whose vertices are
  /// points of the patch or on it. Exact for the rounded centroid. `near`: rows of the patch's vertices among the
  /// corners; may be empty. O(triangles between a corner and the centroid), O(n) without a corner.
  Index triangle_at_centroid(const std::array<Vec3, 3>& corners, std::span<const VertexIndex> near) const;

 private:
  FlatPatch(std::span<const Vec3> points, std::vector<Triangle> triangles)
      : points_(points), triangles_(std::move(triangles)) {}

  bool project();
  bool join();
  void sort_corners();
  static Index next(Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  Vec2 flat(VertexIndex v) const { return projection_(points_[v]); }
  /// Edge that ends the turn about the end of `corner`'s edge through the patch: the next one of the border.
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
