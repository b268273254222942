// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Exact points of the arrangement: homogeneous integers over a power-of-two unit in which every input coordinate is an
/// integer. Neither a division nor a greatest common divisor is ever needed, and constructions are never nested: every
/// point comes from input points alone.
#pragma once

#include <gmpxx.h>

#include <array>
#include <span>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel::arrangement {

/// The point (x, y, z) / w in units of the frame; w > 0.
struct ExactPoint {
  mpz_class x, y, z, w;
  const mpz_class& operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }
};

/// The unit 2^-shift in which all coordinates of the input are integers.
class ExactFrame {
 public:
  ExactFrame() = default;
  explicit ExactFrame(std::span<const Vec3> points);
  mpz_class to_integer(double value) const;
  ExactPoint to_exact(const Vec3& p) const;
  /// Converts a point to exact coordinates, even if its doubles are not integers in the unit.
  ExactPoint to_exact_beyond(const Vec3& p) const;
  /// Returns numerator / denominator in the coordinates' unit, rounded to the nearest double; denominator > 0.
  double ratio(const mpz_class& numerator, const mpz_class& denominator) const;
  /// Returns the nearest doubles to an exact point (ties to even). Rounding is monotone, so a coordinate that lies on
  /// an axis-aligned plane in doubles remains on it. Equal points have equal doubles.
  Vec3 to_nearest(const ExactPoint& p) const;

 private:
  int shift_ = 0;
};

using PlanePoints = std::array<Vec3, 3>;

/// Returns the intersection of the line through p and q with the plane; the line must not be parallel to the plane.
ExactPoint line_plane_point(const ExactFrame& frame, const Vec3& p, const Vec3& q, const PlanePoints& plane);
/// Returns the intersection of three planes, which must meet in one point.
ExactPoint three_planes_point(const ExactFrame& frame, const PlanePoints& a, const PlanePoints& b,
                              const PlanePoints& c);
/// Returns the intersection of the line through p and q with the line through r and s; they must be coplanar and not
/// parallel.
ExactPoint line_line_point(const ExactFrame& frame, const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s);

bool equal(const ExactPoint& a, const ExactPoint& b);
/// Returns the sign of twice the area of the triangle abc in the coordinates i and j.
Sign exact_orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, std::size_t i, std::size_t j);
/// Returns the orientation of an exact point against the plane through three points, as geomesh::orient3d does.
Sign exact_orient3d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d);
/// Returns the sign of the difference a[i] - b[i] between coordinates i of two exact points.
Sign compare_coordinate(const ExactPoint& a, const ExactPoint& b, std::size_t i);
ExactPoint centroid(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c);

}  // namespace geomesh::geomodel::arrangement
