// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Distances between edges, facets and vertices to a few ulps of their coordinates. Angles at which edges cross may be
/// small, and facets thin. Rounded: nothing about validity rests on them.
#pragma once

#include <array>
#include <optional>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel::arrangement {

/// The points of the edges (a, b) and (c, d) that are nearest to each other. Nothing where one of them would be an end
/// or beyond it, or where the edges are parallel (to 1e-6 rad).
std::optional<std::array<Vec3, 2>> nearest_of_edges(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Decides on which side of a triangle's plane a place is, farther from it than a distance.
class PlaneWithin {
 public:
  PlaneWithin(const std::array<Vec3, 3>& triangle, double distance);
  /// 1 above, where the corners turn left, -1 below. 0: no farther than the distance, or rounding leaves that open.
  int side(const Vec3& p) const;

 private:
  Vec3 at_, normal_;
  double distance_, error_;  ///< times the length of the normal; the error a unit of length from the first corner
};

/// Nearer to the plane of the triangle than the distance, and above its inside.
bool is_near_inside(const Vec3& p, const std::array<Vec3, 3>& triangle, double distance);

}  // namespace geomesh::geomodel::arrangement
