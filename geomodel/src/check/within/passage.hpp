// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines how deep input surfaces pass through each other. From a point on their intersection curve each surface is
/// followed in both directions, normal to the curve, until it is farther from the other surface than a given depth. It
/// passes through the other surface if both directions get that far and end on different sides. The sides differ if the
/// line between the two ends crosses the other surface an odd number of times. A surface that ends before it gets that
/// far, or returns, enters the other one by less than the depth, or only touches it.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "check/exact/deviation.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel::checking {

/// Returns the segment in which two triangles pass through each other; nothing if they only touch or lie in one plane.
/// This is decided exactly.
std::optional<std::array<Vec3, 2>> crossing_of(const Corners& s, const Corners& t);

/// A plane normal to an intersection curve at one of its points.
struct CurvePlane {
  Vec3 place, along;
};

/// An input surface with equal points merged, which can be followed along a plane.
class FollowedSurface {
 public:
  explicit FollowedSurface(const TriangulatedSurface& surface);

  const std::vector<Corners>& triangles() const { return corners_; }
  const BoxTree& tree() const { return tree_; }
  const TriangleSet& set() const { return set_; }

  /// Returns the two polylines in which the plane cuts the surface, starting at a point in the given triangle and
  /// ending where the surface ends or the polylines meet. Empty if the plane does not meet the triangle. O(triangles
  /// crossed).
  std::vector<std::vector<Vec3>> lines(Index triangle, const CurvePlane& plane) const;

 private:
  using Edge = std::array<VertexIndex, 2>;
  /// Returns the edge, other than `entered`, by which the plane's cut leaves the triangle; nothing if there is none.
  std::optional<Edge> exit(Index triangle, const CurvePlane& plane, const Edge& entered) const;
  Vec3 cut(const Edge& edge, const CurvePlane& plane) const;
  double height(VertexIndex v, const CurvePlane& plane) const { return dot(points_[v] - plane.place, plane.along); }

  std::vector<Vec3> points_;
  std::vector<Triangle> triangles_;
  std::vector<Corners> corners_;
  std::map<Edge, std::vector<Index>> at_;
  BoxTree tree_;
  TriangleSet set_;
};

/// Functions that passes_through calls while it follows the line in which a plane cuts a surface, until this line is
/// farther than the given depth from another surface.
struct AlongLine {
  std::function<bool(const Vec3&)> ends;  ///< returns whether to end the line at a point, as the surface's border does
  /// Called with each examined point of the line; successive points are at most a quarter of the depth apart.
  std::function<void(const Vec3&)> visit;
};

/// Returns whether the surface, followed from a point in its triangle, passes through the other one and gets farther
/// than `depth` from it on both sides. O(length / depth) queries of the other surface.
bool passes_through(const FollowedSurface& surface, Index triangle, const CurvePlane& plane,
                    const FollowedSurface& other, double depth, const AlongLine& along);

}  // namespace geomesh::geomodel::checking
