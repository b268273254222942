// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Computes distances between edges, facets and vertices to a few ulps of their coordinates, even if edges cross at
/// small angles and facets are thin. The results are rounded; no decision on validity depends on them.
#pragma once

#include <array>
#include <optional>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel::arrangement {

/// Returns the points of the edges (a, b) and (c, d) that are nearest to each other. Returns nothing if one of the
/// points would be an end of its edge or lie beyond it, or if the edges are parallel to within 1e-6 rad.
std::optional<std::array<Vec3, 2>> nearest_of_edges(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Determines the side of a triangle's plane on which a point lies, if it is farther from the plane than a distance.
class PlaneWithin {
 public:
  PlaneWithin(const std::array<Vec3, 3>& triangle, double distance);
  /// Returns 1 for a point p on the side from which the corners are counter-clockwise, -1 on the other; 0 if p is no
  /// farther from the plane than the distance, or if rounding leaves that open.
  int side(const Vec3& p) const;

 private:
  Vec3 at_, normal_;
  /// The distance of the test, and the rounding error of a point's height above the plane, relative to its distance
  /// from the first corner; both are multiplied by the length of `normal_`.
  double distance_, error_;
};

/// Returns whether p is closer to the triangle's plane than the distance, and projects into the triangle's interior.
bool is_near_inside(const Vec3& p, const std::array<Vec3, 3>& triangle, double distance);

}  // namespace geomesh::geomodel::arrangement
