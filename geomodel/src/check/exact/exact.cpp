// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/exact/exact.hpp"

#include <CGAL/Mpzf.h>

#include <cmath>
#include <utility>

namespace geomesh::geomodel::checking {
namespace {

using Exact = CGAL::Mpzf;

/// Products of smaller magnitude may have lost bits to underflow, so the floating-point filter must not decide then.
constexpr double underflow_guard = 1e-280;

Sign sign_of(double value) { return value > 0 ? Sign::positive : value < 0 ? Sign::negative : Sign::zero; }
Sign sign_of(const Exact& value) {
  const auto s = CGAL::sign(value);
  return s == CGAL::POSITIVE ? Sign::positive : s == CGAL::NEGATIVE ? Sign::negative : Sign::zero;
}

struct ExactVector {
  Exact x, y, z;
};
ExactVector difference(const Vec3& a, const Vec3& b) {
  return {Exact(a.x) - Exact(b.x), Exact(a.y) - Exact(b.y), Exact(a.z) - Exact(b.z)};
}
Exact determinant(const ExactVector& u, const ExactVector& v, const ExactVector& w) {
  return u.x * (v.y * w.z - v.z * w.y) + u.y * (v.z * w.x - v.x * w.z) + u.z * (v.x * w.y - v.y * w.x);
}

/// A 3x3 determinant in floating point, with the sum of the magnitudes of its products.
struct Estimate {
  double value, magnitude;
};
Estimate estimate(const Vec3& u, const Vec3& v, const Vec3& w) {
  const double a = v.y * w.z, b = v.z * w.y, c = v.z * w.x, d = v.x * w.z, e = v.x * w.y, f = v.y * w.x;
  return {u.x * (a - b) + u.y * (c - d) + u.z * (e - f), std::abs(u.x) * (std::abs(a) + std::abs(b)) +
                                                             std::abs(u.y) * (std::abs(c) + std::abs(d)) +
                                                             std::abs(u.z) * (std::abs(e) + std::abs(f))};
}

/// Returns true if a column of the matrix with the rows u, v and w is zero. Its entries are differences of equal
/// coordinates, so they are exact, and the determinant is exactly zero.
bool has_zero_column(const Vec3& u, const Vec3& v, const Vec3& w) {
  return (u.x == 0 && v.x == 0 && w.x == 0) || (u.y == 0 && v.y == 0 && w.y == 0) || (u.z == 0 && v.z == 0 && w.z == 0);
}

/// Returns the two coordinates that remain in the projection along `axis`, in cyclic order.
std::array<std::size_t, 2> kept_axes(int axis) {
  return axis == 0   ? std::array<std::size_t, 2>{1, 2}
         : axis == 1 ? std::array<std::size_t, 2>{2, 0}
                     : std::array<std::size_t, 2>{0, 1};
}

}  // namespace

Sign orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const Estimate e = estimate(u, v, w);
  const double bound = 1e-15 * e.magnitude + underflow_guard;
  if (std::abs(e.value) > bound) return sign_of(e.value);
  if (has_zero_column(u, v, w)) return Sign::zero;
  return sign_of(determinant(difference(b, a), difference(c, a), difference(d, a)));
}

Sign projected_orientation(const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
  const auto [i, j] = kept_axes(axis);
  const double left = (b[i] - a[i]) * (c[j] - a[j]), right = (b[j] - a[j]) * (c[i] - a[i]);
  const double value = left - right, bound = 1e-15 * (std::abs(left) + std::abs(right)) + underflow_guard;
  if (std::abs(value) > bound) return sign_of(value);
  const Exact ai(a[i]), aj(a[j]);
  return sign_of((Exact(b[i]) - ai) * (Exact(c[j]) - aj) - (Exact(b[j]) - aj) * (Exact(c[i]) - ai));
}

Sign in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const std::array<Vec3, 4> r{a - e, b - e, c - e, d - e};
  std::array<double, 4> lift{};
  for (int i = 0; i < 4; ++i) lift[i] = dot(r[i], r[i]);
  // The in-sphere determinant is expanded along the lifted column; it is negative if e is inside a positive
  // tetrahedron's sphere.
  constexpr std::array<std::array<int, 3>, 4> minor{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  double value = 0, magnitude = 0;
  for (int i = 0; i < 4; ++i) {
    const Estimate m = estimate(r[minor[i][0]], r[minor[i][1]], r[minor[i][2]]);
    value += lift[i] * m.value;
    magnitude += lift[i] * m.magnitude;
  }
  if (std::abs(value) > 4e-15 * magnitude + underflow_guard) return sign_of(value);
  const std::array<ExactVector, 4> x{difference(a, e), difference(b, e), difference(c, e), difference(d, e)};
  Exact sum(0);
  for (int i = 0; i < 4; ++i)
    sum = sum + (x[i].x * x[i].x + x[i].y * x[i].y + x[i].z * x[i].z) *
                    determinant(x[minor[i][0]], x[minor[i][1]], x[minor[i][2]]);
  return sign_of(sum);
}

int projection_axis(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  std::array<int, 3> axes{0, 1, 2};
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2 - i; ++j)
      if (std::abs(n[axes[j]]) < std::abs(n[axes[j + 1]])) std::swap(axes[j], axes[j + 1]);
  for (const int axis : axes)
    if (projected_orientation(a, b, c, axis) != Sign::zero) return axis;
  return -1;
}

Sign centroid_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& u, const Vec3& v, int axis) {
  const auto [i, j] = kept_axes(axis);
  const Exact three(3), di = Exact(v[i]) - Exact(u[i]), dj = Exact(v[j]) - Exact(u[j]);
  const Exact pi = Exact(a[i]) + Exact(b[i]) + Exact(c[i]) - three * Exact(u[i]);
  const Exact pj = Exact(a[j]) + Exact(b[j]) + Exact(c[j]) - three * Exact(u[j]);
  const Sign s = sign_of(di * pj - dj * pi);
  if (s != Sign::zero) return s;
  const Sign first = sign_of(u[j] - v[j]);  // the centroid is on the line: shift it by an infinitesimal (e, e^2)
  return first != Sign::zero ? first : sign_of(v[i] - u[i]);
}

Sign centroid_orientation(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Exact three(3);
  const auto component = [&](std::size_t i) { return Exact(a[i]) + Exact(b[i]) + Exact(c[i]) - three * Exact(p[i]); };
  return sign_of(
      determinant(difference(q, p), difference(r, p), ExactVector{component(0), component(1), component(2)}));
}

double six_volumes(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const Estimate e = estimate(u, v, w);
  // The determinant's terms hardly cancel, so its floating-point value has a relative error below 1e-12.
  if (std::abs(e.value) > 1e-3 * e.magnitude + underflow_guard) return e.value;
  if (has_zero_column(u, v, w)) return 0;
  return CGAL::to_double(determinant(difference(b, a), difference(c, a), difference(d, a)));
}

Vec3 exact_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
  const ExactVector u = difference(b, a), v = difference(c, a);
  return {CGAL::to_double(u.y * v.z - u.z * v.y), CGAL::to_double(u.z * v.x - u.x * v.z),
          CGAL::to_double(u.x * v.y - u.y * v.x)};
}

struct ExactVolume::Sum {
  Exact six_volumes{0};
};

ExactVolume::ExactVolume() : sum_(new Sum) {}
ExactVolume::~ExactVolume() { delete sum_; }
ExactVolume::ExactVolume(ExactVolume&& other) noexcept : sum_(std::exchange(other.sum_, nullptr)) {}
ExactVolume& ExactVolume::operator=(ExactVolume&& other) noexcept {
  std::swap(sum_, other.sum_);
  return *this;
}

void ExactVolume::add(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  sum_->six_volumes = sum_->six_volumes + determinant(difference(b, a), difference(c, a), difference(d, a));
}

double ExactVolume::value() const { return CGAL::to_double(sum_->six_volumes) / 6; }

}  // namespace geomesh::geomodel::checking
