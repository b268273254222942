// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How deep surfaces of the input pass through each other, and along which lines that can be told.
///
/// At a place of a crossing each surface is followed both ways, normal to the curve. That goes on until it is farther
/// from the other than a depth. It passes through the other where both ends get there, on different sides. How often
/// the line between the ends passes the other surface tells the sides. A surface whose line ends before, or comes
/// back, dips into the other by less than the depth, or grazes it.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "check/exact/deviation.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel::checking {

/// The segment in which triangles pass through each other; nothing where they touch alone or lie in one plane. Whether
/// they do is decided exactly.
std::optional<std::array<Vec3, 2>> crossing_of(const Corners& s, const Corners& t);

/// A plane normal to a curve at one of its places.
struct CurvePlane {
  Vec3 place, along;
};

/// A surface of the input, its equal points as one.
class FollowedSurface {
 public:
  explicit FollowedSurface(const TriangulatedSurface& surface);

  const std::vector<Corners>& triangles() const { return corners_; }
  const BoxTree& tree() const { return tree_; }
  const TriangleSet& set() const { return set_; }

  /// The two lines in which the plane cuts the surface, from the place in a triangle to where the surface ends or the
  /// lines meet. Empty where the plane passes the triangle by. O(triangles passed).
  std::vector<std::vector<Vec3>> lines(Index triangle, const CurvePlane& plane) const;

 private:
  using Edge = std::array<VertexIndex, 2>;
  /// The edge by which the line leaves the triangle, other than `entered`; nothing where there is none.
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

/// What a line is asked at each of its points that is no farther from the other surface than the depth.
struct AlongLine {
  std::function<bool(const Vec3&)> ends;   ///< whether the surface counts as ended there
  std::function<void(const Vec3&)> visit;  ///< told of all points looked at, a quarter of the depth apart at most
};

/// Whether the surface, followed from the place in its triangle, passes through the other one, deeper than that on both
/// sides. O(length / depth) looks at the other surface.
bool passes_through(const FollowedSurface& surface, Index triangle, const CurvePlane& plane,
                    const FollowedSurface& other, double depth, const AlongLine& along);

}  // namespace geomesh::geomodel::checking
