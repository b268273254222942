// SPDX-License-Identifier: MIT
/// @file
/// A convex plane polygon triangulated with points inside it such that no triangle has its three corners on the border.
/// Lifted by their distances from the border, the points make it a roof: a surface over the polygon that meets it in
/// its border alone. Seen along a given axis, the triangulation is Delaunay. So recovery finds nearly all of it in its
/// first triangulation, if that is the axis along which tilted plates are made level.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

struct Roof {
  std::vector<Vec3> inner;          ///< exactly in the plane of the polygon
  std::vector<double> rise;         ///< of each inner point: its distance from the border, seen along that axis
  std::vector<Triangle> triangles;  ///< in the orientation of the polygon; corners of it first, then inner points
};

/// The axis (0 to 2) to look along at the plane through three points.
using AxisChoice = std::function<std::size_t(const std::array<Vec3, 3>&)>;

/// `corners`: of a convex polygon exactly in a plane, as three or more doubles in order; angles of 180 degrees are
/// allowed. Points are added to the circumcircles of triangles whose corners are all on the border. Nothing where no
/// double is found in the plane for one of them, or where that takes as many points as there are corners.
/// O(n) for each point, O(n log n) for each round of some log n.
std::optional<Roof> roof_over(std::span<const Vec3> corners, const AxisChoice& axis_for);

}  // namespace geomesh
