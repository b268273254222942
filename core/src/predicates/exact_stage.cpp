// SPDX-License-Identifier: MIT
#include "predicates/exact_stage.hpp"

#include <cmath>

#include "predicates/expansion.hpp"
#include "predicates/filters.hpp"
#include "predicates/two_double.hpp"

namespace geomesh::exact {
namespace {

/// Computes a - b if that is exact; otherwise returns false.
bool exact_difference(double a, double b, double& d) {
  double tail;
  two_difference(a, b, d, tail);
  return tail == 0;
}

bool exact_difference(const Vec3& a, const Vec3& b, Vec3& d) {
  return exact_difference(a.x, b.x, d.x) && exact_difference(a.y, b.y, d.y) && exact_difference(a.z, b.z, d.z);
}

/// Returns det [a; b; c].
Expansion<24> det3(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (minor2(a.x, b.y, b.x, a.y) * c.z + minor2(b.x, c.y, c.x, b.y) * a.z) + minor2(c.x, a.y, a.x, c.y) * b.z;
}

/// Returns det [b - a; c - a; d - a], expanded in the coordinates without differences.
Expansion<96> orient3d_expansion(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (det3(b, c, d) - det3(a, c, d)) + (det3(a, b, d) - det3(a, b, c));
}

Expansion<12> orient2d_expansion(double ax, double ay, double bx, double by, double cx, double cy) {
  return (minor2(ax, by, bx, ay) + minor2(bx, cy, cx, by)) + minor2(cx, ay, ax, cy);
}

Expansion<6> squared_length(const Vec3& a) {
  auto square = [](double x) { return single(x) * x; };
  return (square(a.x) + square(a.y)) + square(a.z);
}

template <int N>
Expansion<12 * N> times_lift(const Expansion<N>& e, const Vec3& p) {
  return (e * p.x * p.x + e * p.y * p.y) + e * p.z * p.z;
}

template <int N>
Expansion<8 * N> times_lift(const Expansion<N>& e, const Vec2& p) {
  return e * p.x * p.x + e * p.y * p.y;
}

/// Multiplies e by the short expansion f: scales e with each term of f and adds the results.
template <int N>
Expansion<12 * N> product(const Expansion<N>& e, const Expansion<6>& f) {
  Expansion<2 * N> part[6];
  for (int i = 0; i < f.size; ++i) {
    const Expansion<2 * N> scaled = e * f.term[i];
    part[i].size = scaled.size;
    for (int k = 0; k < scaled.size; ++k) part[i].term[k] = scaled.term[k];
  }
  return ((part[0] + part[1]) + (part[2] + part[3])) + (part[4] + part[5]);
}

Sign in_sphere_of_differences(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto da = product(det3(b, c, d), squared_length(a)), db = product(det3(a, c, d), squared_length(b));
  const auto dc = product(det3(a, b, d), squared_length(c)), dd = product(det3(a, b, c), squared_length(d));
  return ((da - db) + (dc - dd)).sign();
}

}  // namespace

Sign orient2d(double ax, double ay, double bx, double by, double cx, double cy) {
  double ux, uy, vx, vy;
  if (exact_difference(ax, cx, ux) && exact_difference(ay, cy, uy) && exact_difference(bx, cx, vx) &&
      exact_difference(by, cy, vy))
    return minor2(ux, vy, uy, vx).sign();
  return orient2d_expansion(ax, ay, bx, by, cx, cy).sign();
}

Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Vec3 u, v, w;
  if (exact_difference(a, d, u) && exact_difference(b, d, v) && exact_difference(c, d, w)) return -det3(u, v, w).sign();
  return orient3d_expansion(a, b, c, d).sign();
}

Sign in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto wa = times_lift(orient2d_expansion(b.x, b.y, c.x, c.y, d.x, d.y), a);
  const auto wb = times_lift(orient2d_expansion(a.x, a.y, c.x, c.y, d.x, d.y), b);
  const auto wc = times_lift(orient2d_expansion(a.x, a.y, b.x, b.y, d.x, d.y), c);
  const auto wd = times_lift(orient2d_expansion(a.x, a.y, b.x, b.y, c.x, c.y), d);
  return ((wa - wb) + (wc - wd)).sign();
}

Sign in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  Vec3 ae, be, ce, de;
  if (exact_difference(a, e, ae) && exact_difference(b, e, be) && exact_difference(c, e, ce) &&
      exact_difference(d, e, de))
    return in_sphere_of_differences(ae, be, ce, de);
  const auto wa = times_lift(orient3d_expansion(b, c, d, e), a), wb = times_lift(orient3d_expansion(a, c, d, e), b);
  const auto wc = times_lift(orient3d_expansion(a, b, d, e), c), wd = times_lift(orient3d_expansion(a, b, c, e), d);
  const auto we = times_lift(orient3d_expansion(a, b, c, d), e);
  return (((wb - wa) + (wd - wc)) - we).sign();
}

}  // namespace geomesh::exact

namespace geomesh::detail {
namespace {

template <class Number>
struct Vector {
  Number x, y, z;
};

Vector<double> vector_from(const Vec3& a, const Vec3& origin, double) {
  return {a.x - origin.x, a.y - origin.y, a.z - origin.z};
}
Vector<exact::TwoDouble> vector_from(const Vec3& a, const Vec3& origin, exact::TwoDouble) {
  return {exact::TwoDouble::difference(a.x, origin.x), exact::TwoDouble::difference(a.y, origin.y),
          exact::TwoDouble::difference(a.z, origin.z)};
}

template <class Number>
Number det3(const Vector<Number>& u, const Vector<Number>& v, const Vector<Number>& w) {
  return (u.z * (v.x * w.y - w.x * v.y) + v.z * (w.x * u.y - u.x * w.y)) + w.z * (u.x * v.y - v.x * u.y);
}
/// Returns the sum of the magnitudes of all products in det3, for error bounds.
double permanent3(const Vector<double>& u, const Vector<double>& v, const Vector<double>& w) {
  const auto pair = [](double a, double b, double c, double d) { return std::fabs(a * b) + std::fabs(c * d); };
  return std::fabs(u.z) * pair(v.x, w.y, w.x, v.y) + std::fabs(v.z) * pair(w.x, u.y, u.x, w.y) +
         std::fabs(w.z) * pair(u.x, v.y, v.x, u.y);
}

/// Returns the in-sphere determinant of a, b, c and d, given relative to the fifth point.
template <class Number>
Number in_sphere_det(const Vector<Number>* p) {
  const auto lift = [](const Vector<Number>& v) { return (v.x * v.x + v.y * v.y) + v.z * v.z; };
  return (lift(p[0]) * det3(p[1], p[2], p[3]) - lift(p[1]) * det3(p[0], p[2], p[3])) +
         (lift(p[2]) * det3(p[0], p[1], p[3]) - lift(p[3]) * det3(p[0], p[1], p[2]));
}
double in_sphere_permanent(const Vector<double>* p) {
  const auto lift = [](const Vector<double>& v) { return v.x * v.x + v.y * v.y + v.z * v.z; };
  return lift(p[0]) * permanent3(p[1], p[2], p[3]) + lift(p[1]) * permanent3(p[0], p[2], p[3]) +
         lift(p[2]) * permanent3(p[0], p[1], p[3]) + lift(p[3]) * permanent3(p[0], p[1], p[2]);
}

Sign sign_of(double x) { return x > 0 ? Sign::positive : Sign::negative; }

}  // namespace

// Error bounds of the dynamic filters. In doubles they are those of filters.hpp, relative to the sum of the magnitudes
// of the products. In TwoDouble a product passes through at most 12 operations of 6 u^2 each: 72 u^2 = 2^-99.8 < 2^-98.

Sign orient3d_after_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, std::size_t& exact_calls) {
  const auto u = vector_from(a, d, 0.0), v = vector_from(b, d, 0.0), w = vector_from(c, d, 0.0);
  const double det = det3(u, v, w), permanent = permanent3(u, v, w);
  if (std::fabs(det) > filter::orient3d_permanent_factor * permanent) return -sign_of(det);
  // each product in the determinant is zero, so it is exactly 0 (points in a plane perpendicular to an axis)
  if (permanent == 0) return Sign::zero;
  const exact::TwoDouble fine = det3(vector_from(a, d, exact::TwoDouble{}), vector_from(b, d, exact::TwoDouble{}),
                                     vector_from(c, d, exact::TwoDouble{}));
  if (std::fabs(fine.hi) > 0x1p-98 * permanent) return -sign_of(fine.hi);
  ++exact_calls;
  return exact::orient3d(a, b, c, d);
}

Sign in_sphere_after_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                            std::size_t& exact_calls) {
  const Vector<double> p[4] = {vector_from(a, e, 0.0), vector_from(b, e, 0.0), vector_from(c, e, 0.0),
                               vector_from(d, e, 0.0)};
  const double det = in_sphere_det(p), permanent = in_sphere_permanent(p);
  if (std::fabs(det) > filter::in_sphere_permanent_factor * permanent) return sign_of(det);
  const Vector<exact::TwoDouble> q[4] = {vector_from(a, e, exact::TwoDouble{}), vector_from(b, e, exact::TwoDouble{}),
                                         vector_from(c, e, exact::TwoDouble{}), vector_from(d, e, exact::TwoDouble{})};
  const exact::TwoDouble fine = in_sphere_det(q);
  if (std::fabs(fine.hi) > 0x1p-98 * permanent) return sign_of(fine.hi);
  ++exact_calls;
  return exact::in_sphere(a, b, c, d, e);
}

}  // namespace geomesh::detail
