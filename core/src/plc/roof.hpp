// SPDX-License-Identifier: MIT
/// @file
/// A convex plane polygon triangulated with points inside it such that no triangle has its three corners on the border.
/// Lifted by their distances from the border, the points form a roof: a surface over the polygon that meets it only in
/// its border. Projected along a given axis, the triangulation is Delaunay. Recovery therefore finds nearly all of it
/// in its first triangulation, if it makes tilted plates horizontal along the same axis.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

struct Roof {
  std::vector<Vec3> inner;   ///< points added inside the polygon, exactly in its plane
  std::vector<double> rise;  ///< distance of each inner point from the polygon's border, in the projection
  /// Triangles, oriented like the polygon. Their vertices are the polygon's corners, followed by inner points.
  std::vector<Triangle> triangles;
};

/// Returns the axis (0 to 2) along which to project the plane through three points.
using AxisChoice = std::function<std::size_t(const std::array<Vec3, 3>&)>;

/// Builds a roof over a convex and exactly plane polygon. `corners` are three or more points in order; angles of 180
/// degrees are allowed. Points are added in the circumcircles of triangles whose corners are all on the border. Returns
/// nothing if no point in doubles is found in the plane for such a triangle, or if as many points as corners would be
/// needed. O(n) for each point, O(n log n) for each of about log n rounds.
std::optional<Roof> roof_over(std::span<const Vec3> corners, const AxisChoice& axis_for);

}  // namespace geomesh
