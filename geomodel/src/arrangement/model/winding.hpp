// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Computes winding numbers by exact rays along an axis; a symbolic shift of the ray excludes degenerate cases.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "arrangement/model/complex.hpp"
#include "arrangement/model/exact_point.hpp"

namespace geomesh::geomodel::arrangement {

/// A ray along an axis; `up` means towards larger coordinates.
struct RayDirection {
  std::size_t axis = 2;
  bool up = true;
};

/// Closed oriented triangles, prepared for queries of winding numbers. Triangles without area are ignored.
class WindingNumber {
 public:
  WindingNumber(std::span<const Vec3> points, std::vector<Triangle> triangles);

  /// Returns the winding number around the point q, zero outside. `rounded` contains the nearest doubles of q.
  /// Triangles listed in `skip` (ascending) are not counted; q may lie on those, but on no others.
  int operator()(const ExactFrame& frame, const ExactPoint& q, const Vec3& rounded, RayDirection ray,
                 std::span<const Index> skip = {}) const;
  /// Returns the winding number around the point q, which must not lie on a triangle.
  int operator()(const Vec3& q, RayDirection ray) const;

  /// Returns what triangle t, which the ray crosses, adds to the winding number of points on its lower side along the
  /// axis.
  int contribution(Index t, std::size_t axis) const;
  const Box3& box() const { return box_; }

 private:
  template <typename Query>
  int count(const Query& query, const Vec3& rounded, RayDirection ray, std::span<const Index> skip) const;
  std::span<const Vec3> points_;
  std::vector<Triangle> triangles_;
  Box3 box_;
};

}  // namespace geomesh::geomodel::arrangement
