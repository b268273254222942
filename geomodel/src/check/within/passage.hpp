// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines how deep surfaces of the input pass through each other. From a point of a crossing each surface is
/// followed in both directions, normal to the curve, until it is farther from the other surface than a given depth. It
/// passes through the other one if both ends get that far, on different sides. The parity of the number of times that
/// the line between the ends crosses the other surface determines the sides. A surface whose line ends before, or
/// returns, enters the other one by less than the depth, or touches it.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "check/exact/deviation.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel::checking {

/// Returns the segment in which triangles pass through each other; nothing if they only touch or lie in one plane.
/// Whether they do is decided exactly.
std::optional<std::array<Vec3, 2>> crossing_of(const Corners& s, const Corners& t);

/// A plane normal to a curve at one of its points.
struct CurvePlane {
  Vec3 place, along;
};

/// A surface of the input with equal points merged.
class FollowedSurface {
 public:
  explicit FollowedSurface(const TriangulatedSurface& surface);

  const std::vector<Corners>& triangles() const { return corners_; }
  const BoxTree& tree() const { return tree_; }
  const TriangleSet& set() const { return set_; }

  /// Returns the two lines in which the plane cuts the surface, from the point in a triangle to where the surface ends
  /// or the lines meet. Empty if the plane does not meet the triangle. O(triangles crossed).
  std::vector<std::vector<Vec3>> lines(Index triangle, const CurvePlane& plane) const;

 private:
  using Edge = std::array<VertexIndex, 2>;
  /// Returns the edge by which the line leaves the triangle, other than `entered`; nothing if there is none.
  std::optional<Edge> exit(Index triangle, const CurvePlane& plane, const Edge& entered) const;
  Vec3 cut(const Edge& edge, const CurvePlane& plane) const;
  double height(VertexIndex v, const CurvePlane& plane) const { return dot(points_[v] - plane.place, plane.along); }

  std::vector<Vec3> points_;
  std::vector<Triangle> triangles_;
  std::vector<Corners> corners_;
  std::map<Edge, std::vector<Index>> at_;  ///< triangles at each edge
  BoxTree tree_;
  TriangleSet set_;
};

/// Functions that are evaluated at each point of a line that is no farther from the other surface than the depth.
struct AlongLine {
  std::function<bool(const Vec3&)> ends;  ///< returns whether the surface counts as ended there
  /// Called with all points that are examined, at most a quarter of the depth apart.
  std::function<void(const Vec3&)> visit;
};

/// Returns whether the surface, followed from the point in its triangle, passes through the other one, deeper than that
/// on both sides. O(length / depth) queries of the other surface.
bool passes_through(const FollowedSurface& surface, Index triangle, const CurvePlane& plane,
                    const FollowedSurface& other, double depth, const AlongLine& along);

}  // namespace geomesh::geomodel::checking
