// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// An input triangle with its plane, for deciding which mesh faces lie on it. Normals and distances come from exact
/// determinants, so that needles are handled as accurately as other triangles; areas and clipping are in doubles
/// relative to a corner.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel::checking {

class PlaneTriangle {
 public:
  PlaneTriangle(const Vec3& a, const Vec3& b, const Vec3& c);

  bool degenerate() const { return length_ == 0; }
  double area() const { return 0.5 * length_; }
  double perimeter() const;
  const Vec3& normal() const { return normal_; }  ///< of unit length
  const std::array<Vec3, 3>& corners() const { return corner_; }

  double distance(const Vec3& p) const;
  /// Returns how far p, projected into the triangle's plane, is outside the triangle (0: inside), measured to the lines
  /// of its sides.
  double outside(const Vec3& p) const;
  /// Returns whether p and q, projected into the triangle's plane, are both beyond the line of the same side, or at
  /// most `tolerance` within it.
  bool are_beyond_a_side(const Vec3& p, const Vec3& q, double tolerance) const;
  /// Returns the area that this triangle shares with the triangle p q r after p q r is projected into its plane.
  double common_area(const Vec3& p, const Vec3& q, const Vec3& r) const;
  double area_inside(const Box3& box) const;
  /// Returns the triangle's part inside the box as a convex polygon; empty if it has fewer than three points.
  std::vector<Vec3> inside(const Box3& box) const;

 private:
  Vec2 project(const Vec3& p) const;

  std::array<Vec3, 3> corner_;
  Vec3 normal_, axis_u_, axis_v_;  ///< unit vectors
  double length_;                  ///< twice the area
  std::array<Vec2, 3> flat_;  ///< corners in plane coordinates with the origin in the first corner, counter-clockwise
};

}  // namespace geomesh::geomodel::checking
