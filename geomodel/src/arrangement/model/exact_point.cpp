// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/model/exact_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace geomesh::geomodel::arrangement {
namespace {

using Vector = std::array<mpz_class, 3>;

/// Splits a double into its mantissa, as an odd integer or zero, and the exponent of the mantissa's unit.
std::pair<std::int64_t, int> split(double value) {
  int exponent = 0;
  auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  if (mantissa == 0) return {0, 0};
  const int zeros = __builtin_ctzll(static_cast<unsigned long long>(mantissa));
  return {mantissa / (std::int64_t{1} << zeros), exponent + zeros};
}

Vector integers(const ExactFrame& frame, const Vec3& p) {
  return {frame.to_integer(p.x), frame.to_integer(p.y), frame.to_integer(p.z)};
}
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
mpz_class dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector normal(const ExactFrame& frame, const PlanePoints& plane) {
  const Vector a = integers(frame, plane[0]);
  return cross(minus(integers(frame, plane[1]), a), minus(integers(frame, plane[2]), a));
}

ExactPoint normalised(ExactPoint p) {
  if (sgn(p.w) < 0) {
    p.x = -p.x;
    p.y = -p.y;
    p.z = -p.z;
    p.w = -p.w;
  }
  return p;
}
std::uint64_t lowest_64_bits(const mpz_class& positive) {
  if constexpr (sizeof(unsigned long) >= sizeof(std::uint64_t)) {
    return mpz_get_ui(positive.get_mpz_t());
  } else {  // `long` has 32 bits on Windows and on 32-bit machines
    const mpz_class high = positive >> 32;
    return std::uint64_t{mpz_get_ui(high.get_mpz_t())} << 32 | (mpz_get_ui(positive.get_mpz_t()) & 0xFFFFFFFFu);
  }
}
Sign to_sign(int s) { return s > 0 ? Sign::positive : s < 0 ? Sign::negative : Sign::zero; }

}  // namespace

ExactFrame::ExactFrame(std::span<const Vec3> points) {
  int lowest = 0;
  for (const Vec3& p : points)
    for (std::size_t i = 0; i < 3; ++i)
      if (p[i] != 0) lowest = std::min(lowest, split(p[i]).second);
  shift_ = -lowest;
}

mpz_class ExactFrame::to_integer(double value) const {
  const auto [mantissa, exponent] = split(value);
  mpz_class result;
  if constexpr (sizeof(long) >= sizeof mantissa)
    result = static_cast<long>(mantissa);
  else
    result = static_cast<double>(mantissa);  // GMP converts the integer in this double exactly, even with 32-bit `long`
  const int up = exponent + shift_;
  if (mantissa != 0) mpz_mul_2exp(result.get_mpz_t(), result.get_mpz_t(), static_cast<mp_bitcnt_t>(up));
  return result;
}

ExactPoint ExactFrame::to_exact(const Vec3& p) const { return {to_integer(p.x), to_integer(p.y), to_integer(p.z), 1}; }

ExactPoint ExactFrame::to_exact_beyond(const Vec3& p) const {
  int lowest = -shift_;
  for (std::size_t i = 0; i < 3; ++i)
    if (p[i] != 0) lowest = std::min(lowest, split(p[i]).second);
  ExactFrame finer;
  finer.shift_ = -lowest;
  ExactPoint result = finer.to_exact(p);
  result.w <<= static_cast<mp_bitcnt_t>(finer.shift_ - shift_);
  return result;
}

double ExactFrame::ratio(const mpz_class& numerator, const mpz_class& denominator) const {
  if (sgn(numerator) == 0) return 0;
  mpz_class n = abs(numerator), d = denominator;
  // Uses 55 or 56 significant bits of the quotient, of which the last one is sticky. Conversion to double then rounds
  // to nearest, ties to even.
  const long scale =
      55 - (static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2)) - static_cast<long>(mpz_sizeinbase(d.get_mpz_t(), 2)));
  if (scale > 0)
    n <<= static_cast<mp_bitcnt_t>(scale);
  else
    d <<= static_cast<mp_bitcnt_t>(-scale);
  mpz_class q, r;
  mpz_tdiv_qr(q.get_mpz_t(), r.get_mpz_t(), n.get_mpz_t(), d.get_mpz_t());
  std::uint64_t bits = lowest_64_bits(q);
  if (sgn(r) != 0) bits |= 1;
  const double magnitude = std::ldexp(static_cast<double>(bits), static_cast<int>(-scale - shift_));
  return sgn(numerator) < 0 ? -magnitude : magnitude;
}

Vec3 ExactFrame::to_nearest(const ExactPoint& p) const { return {ratio(p.x, p.w), ratio(p.y, p.w), ratio(p.z, p.w)}; }

ExactPoint line_plane_point(const ExactFrame& frame, const Vec3& p, const Vec3& q, const PlanePoints& plane) {
  const Vector n = normal(frame, plane), a = integers(frame, plane[0]);
  const Vector pi = integers(frame, p), qi = integers(frame, q);
  const mpz_class dp = dot(n, minus(pi, a)), dq = dot(n, minus(qi, a));
  return normalised({pi[0] * dq - qi[0] * dp, pi[1] * dq - qi[1] * dp, pi[2] * dq - qi[2] * dp, dq - dp});
}

ExactPoint three_planes_point(const ExactFrame& frame, const PlanePoints& a, const PlanePoints& b,
                              const PlanePoints& c) {
  const Vector na = normal(frame, a), nb = normal(frame, b), nc = normal(frame, c);
  const Vector origin = integers(frame, a[0]);
  const mpz_class db = dot(nb, minus(integers(frame, b[0]), origin)),
                  dc = dot(nc, minus(integers(frame, c[0]), origin));
  const Vector ca = cross(nc, na), ab = cross(na, nb);
  const mpz_class w = dot(na, cross(nb, nc));
  return normalised({db * ca[0] + dc * ab[0] + origin[0] * w, db * ca[1] + dc * ab[1] + origin[1] * w,
                     db * ca[2] + dc * ab[2] + origin[2] * w, w});
}

ExactPoint line_line_point(const ExactFrame& frame, const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  const Vector pi = integers(frame, p), ri = integers(frame, r);
  const Vector u = minus(integers(frame, q), pi), v = minus(integers(frame, s), ri), d = minus(ri, pi);
  const Vector uv = cross(u, v), dv = cross(d, v);
  const std::size_t k = sgn(uv[0]) != 0 ? 0 : sgn(uv[1]) != 0 ? 1 : 2;
  return normalised({pi[0] * uv[k] + u[0] * dv[k], pi[1] * uv[k] + u[1] * dv[k], pi[2] * uv[k] + u[2] * dv[k], uv[k]});
}

bool equal(const ExactPoint& a, const ExactPoint& b) {
  return a.x * b.w == b.x * a.w && a.y * b.w == b.y * a.w && a.z * b.w == b.z * a.w;
}

Sign exact_orient2d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, std::size_t i, std::size_t j) {
  const mpz_class det =
      a[i] * (b[j] * c.w - c[j] * b.w) - a[j] * (b[i] * c.w - c[i] * b.w) + a.w * (b[i] * c[j] - c[i] * b[j]);
  return to_sign(sgn(det));
}

Sign exact_orient3d(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d) {
  const auto difference = [&a](const ExactPoint& p) -> Vector {
    return {p.x * a.w - a.x * p.w, p.y * a.w - a.y * p.w, p.z * a.w - a.z * p.w};
  };
  return to_sign(sgn(dot(cross(difference(b), difference(c)), difference(d))));
}

Sign compare_coordinate(const ExactPoint& a, const ExactPoint& b, std::size_t i) {
  return to_sign(cmp(a[i] * b.w, b[i] * a.w));
}

ExactPoint centroid(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  const mpz_class bc = b.w * c.w, ac = a.w * c.w, ab = a.w * b.w;
  return {a.x * bc + b.x * ac + c.x * ab, a.y * bc + b.y * ac + c.y * ab, a.z * bc + b.z * ac + c.z * ab, 3 * a.w * bc};
}

}  // namespace geomesh::geomodel::arrangement
