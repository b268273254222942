// SPDX-License-Identifier: MIT
/// @file
/// Semi-static filters of the predicates: the determinant in doubles is compared with an error bound that is computed
/// in each call from the largest differences of coordinates. One global bound would nearly always leave the sign open
/// on models whose spacings span many orders of magnitude.
///
/// Bounds, with u = 2^-53. Each difference has a relative error of u. Every product of the expanded determinant passes
/// through a number of roundings. Each has relative size u of a quantity that is at most the sum of the magnitudes of
/// the products:
///   orient2d : 2 products, 2 differences + product + final subtraction              = 4 u  -> 8 u X Y;
///   orient3d : 6 products, 3 differences + (2x2: 2) + product + two sums            = 8 u  -> 48 u X Y Z;
///   in_circle: 6 products, 2 differences, lift (2 + product + sum = 4), 2, 1, 2     = 11 u -> 66 u X Y L;
///   in_sphere: 24 products, 3 differences, lift (2 + product + two sums = 5), 2x2 (2), 3x3 (product + two sums = 3),
///              product, three sums (3)                                              = 17 u -> 408 u X Y Z L.
/// L is X^2 + Y^2 or X^2 + Y^2 + Z^2, which is at least the lift. The factors used are about a tenth larger, which
/// covers terms of second order and the rounding of the bound.
#pragma once

#include <cmath>

#include "geomesh/core/geometry.hpp"

namespace geomesh::filter {

inline constexpr double unit = 1.1102230246251565e-16;  ///< 2^-53
inline constexpr double orient2d_factor = 10 * unit;
inline constexpr double orient3d_factor = 54 * unit;
inline constexpr double in_circle_factor = 74 * unit;
inline constexpr double in_sphere_factor = 450 * unit;
/// Factors of error bounds relative to the sum of the magnitudes of the actual products. This sum is at most the number
/// of products times X Y Z (L). The factors are slightly more than 8 u and 17 u.
inline constexpr double orient3d_permanent_factor = 10 * unit;
inline constexpr double in_sphere_permanent_factor = 22 * unit;

/// A determinant in doubles and a bound on its error; its sign is certain if |value| > error.
struct Estimate {
  double value, error;
  bool certain() const { return value > error || value < -error; }
  Sign sign() const { return value > 0 ? Sign::positive : Sign::negative; }
};

inline double max2(double a, double b) { return a > b ? a : b; }
inline double max3(double a, double b, double c) { return max2(max2(a, b), c); }
inline double max4(double a, double b, double c, double d) { return max2(max2(a, b), max2(c, d)); }

inline Estimate orient2d(double ax, double ay, double bx, double by, double cx, double cy) {
  const double ux = bx - ax, uy = by - ay, vx = cx - ax, vy = cy - ay;
  const double x = max2(std::fabs(ux), std::fabs(vx)), y = max2(std::fabs(uy), std::fabs(vy));
  return {ux * vy - uy * vx, orient2d_factor * x * y};
}

/// Computes the determinant of orient3d, from the differences of a, b and c to d, and its error bound.
template <class P, class Q>
inline Estimate orient3d(const P& a, const P& b, const P& c, const Q& d) {
  const double ax = a.x - d.x, ay = a.y - d.y, az = a.z - d.z;
  const double bx = b.x - d.x, by = b.y - d.y, bz = b.z - d.z;
  const double cx = c.x - d.x, cy = c.y - d.y, cz = c.z - d.z;
  const double x = max3(std::fabs(ax), std::fabs(bx), std::fabs(cx));
  const double y = max3(std::fabs(ay), std::fabs(by), std::fabs(cy));
  const double z = max3(std::fabs(az), std::fabs(bz), std::fabs(cz));
  const double det = az * (bx * cy - by * cx) + bz * (cx * ay - cy * ax) + cz * (ax * by - ay * bx);
  return {-det, orient3d_factor * x * y * z};
}

/// The part of orient3d(a, b, c, d) that is common to many points a. It is constructed from b - d and c - d, and
/// evaluated for each a - d.
class Orient3dOfMany {
 public:
  Orient3dOfMany(const Vec3& v, const Vec3& w)
      : minor_{v.y * w.z - v.z * w.y, v.z * w.x - v.x * w.z, v.x * w.y - v.y * w.x},
        permanent_{std::fabs(v.y * w.z) + std::fabs(v.z * w.y), std::fabs(v.z * w.x) + std::fabs(v.x * w.z),
                   std::fabs(v.x * w.y) + std::fabs(v.y * w.x)} {}
  Estimate operator()(const Vec3& u) const {
    return {-(u.x * minor_.x + u.y * minor_.y + u.z * minor_.z),
            orient3d_permanent_factor *
                (std::fabs(u.x) * permanent_.x + std::fabs(u.y) * permanent_.y + std::fabs(u.z) * permanent_.z)};
  }

 private:
  Vec3 minor_, permanent_;
};

inline Estimate in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
  const double x = max3(std::fabs(ax), std::fabs(bx), std::fabs(cx));
  const double y = max3(std::fabs(ay), std::fabs(by), std::fabs(cy));
  const double det = (ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax) +
                     (cx * cx + cy * cy) * (ax * by - ay * bx);
  return {det, in_circle_factor * x * y * (x * x + y * y)};
}

template <class P, class Q>
inline Estimate in_sphere(const P& a, const P& b, const P& c, const P& d, const Q& e) {
  const double ax = a.x - e.x, ay = a.y - e.y, az = a.z - e.z;
  const double bx = b.x - e.x, by = b.y - e.y, bz = b.z - e.z;
  const double cx = c.x - e.x, cy = c.y - e.y, cz = c.z - e.z;
  const double dx = d.x - e.x, dy = d.y - e.y, dz = d.z - e.z;
  const double x = max4(std::fabs(ax), std::fabs(bx), std::fabs(cx), std::fabs(dx));
  const double y = max4(std::fabs(ay), std::fabs(by), std::fabs(cy), std::fabs(dy));
  const double z = max4(std::fabs(az), std::fabs(bz), std::fabs(cz), std::fabs(dz));
  const double ab = ax * by - bx * ay, bc = bx * cy - cx * by, cd = cx * dy - dx * cy;
  const double da = dx * ay - ax * dy, ac = ax * cy - cx * ay, bd = bx * dy - dx * by;
  const double abc = az * bc - bz * ac + cz * ab, bcd = bz * cd - cz * bd + dz * bc;
  const double cda = cz * da + dz * ac + az * cd, dab = dz * ab + az * bd + bz * da;
  const double a2 = ax * ax + ay * ay + az * az, b2 = bx * bx + by * by + bz * bz;
  const double c2 = cx * cx + cy * cy + cz * cz, d2 = dx * dx + dy * dy + dz * dz;
  const double det = (d2 * abc - c2 * dab) + (b2 * cda - a2 * bcd);
  return {-det, in_sphere_factor * (x * y) * z * (x * x + y * y + z * z)};
}

}  // namespace geomesh::filter
