// SPDX-License-Identifier: MIT
#include "predicates/exact_stage.hpp"

#include <cmath>

#include "predicates/expansion.hpp"

namespace geomesh::exact {
namespace {

/// a - b where that is exact; false otherwise.
bool exact_difference(double a, double b, double& d) {
  double tail;
  two_difference(a, b, d, tail);
  return tail == 0;
}

bool exact_difference(const Vec3& a, const Vec3& b, Vec3& d) {
  return exact_difference(a.x, b.x, d.x) && exact_difference(a.y, b.y, d.y) && exact_difference(a.z, b.z, d.z);
}

/// det [a; b; c].
Expansion<24> det3(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (minor2(a.x, b.y, b.x, a.y) * c.z + minor2(b.x, c.y, c.x, b.y) * a.z) + minor2(c.x, a.y, a.x, c.y) * b.z;
}

/// det [b - a; c - a; d - a] from the coordinates themselves.
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

/// e * f by scaling e with each term of f and summing; f is short.
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
  if (exact_difference(ax, cx, ux) && exact_difference(ay, cy, uy) && exact_difference(bx, cx, vx) && exact_difference(by, cy, vy))
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
  if (exact_difference(a, e, ae) && exact_difference(b, e, be) && exact_difference(c, e, ce) && exact_difference(d, e, de))
    return in_sphere_of_differences(ae, be, ce, de);
  const auto wa = times_lift(orient3d_expansion(b, c, d, e), a), wb = times_lift(orient3d_expansion(a, c, d, e), b);
  const auto wc = times_lift(orient3d_expansion(a, b, d, e), c), wd = times_lift(orient3d_expansion(a, b, c, e), d);
  const auto we = times_lift(orient3d_expansion(a, b, c, d), e);
  return (((wb - wa) + (wd - wc)) - we).sign();
}

}  // namespace geomesh::exact

namespace geomesh::detail {
namespace {

constexpr double unit = 1.1102230246251565e-16;

}  // namespace

// The bounds count roundings as filters.hpp does, against the sum of the magnitudes of the products instead of its upper limit.

Sign orient3d_after_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, std::size_t& exact_calls) {
  const Vec3 u = a - d, v = b - d, w = c - d;
  const double p = v.x * w.y, q = w.x * v.y, r = w.x * u.y, s = u.x * w.y, t = u.x * v.y, o = v.x * u.y;
  const double det = u.z * (p - q) + v.z * (r - s) + w.z * (t - o);
  const double magnitude = std::fabs(u.z) * (std::fabs(p) + std::fabs(q)) + std::fabs(v.z) * (std::fabs(r) + std::fabs(s)) +
                           std::fabs(w.z) * (std::fabs(t) + std::fabs(o));
  if (std::fabs(det) > 10 * unit * magnitude) return det > 0 ? Sign::negative : Sign::positive;
  ++exact_calls;
  return exact::orient3d(a, b, c, d);
}

Sign in_sphere_after_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e, std::size_t& exact_calls) {
  const Vec3 p[4] = {a - e, b - e, c - e, d - e};
  double det = 0, magnitude = 0;
  for (int i = 0; i < 4; ++i) {
    const Vec3 &u = p[i == 0 ? 1 : 0], &v = p[i <= 1 ? 2 : 1], &w = p[i <= 2 ? 3 : 2];
    const double vw = v.x * w.y, wv = w.x * v.y, wu = w.x * u.y, uw = u.x * w.y, uv = u.x * v.y, vu = v.x * u.y;
    const double lift = dot(p[i], p[i]);
    const double minor = u.z * (vw - wv) + v.z * (wu - uw) + w.z * (uv - vu);
    const double size = std::fabs(u.z) * (std::fabs(vw) + std::fabs(wv)) + std::fabs(v.z) * (std::fabs(wu) + std::fabs(uw)) +
                        std::fabs(w.z) * (std::fabs(uv) + std::fabs(vu));
    det += (i % 2 == 0 ? lift : -lift) * minor;
    magnitude += lift * size;
  }
  if (std::fabs(det) > 22 * unit * magnitude) return det > 0 ? Sign::positive : Sign::negative;
  ++exact_calls;
  return exact::in_sphere(a, b, c, d, e);
}

}  // namespace geomesh::detail
