// SPDX-License-Identifier: MIT
#include "geomesh/core/predicates.hpp"

#include <cmath>

#include "predicates/exact_stage.hpp"
#include "predicates/filters.hpp"

namespace geomesh {

Sign orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  const filter::Estimate estimate = filter::orient2d(a.x, a.y, b.x, b.y, c.x, c.y);
  return estimate.certain() ? estimate.sign() : exact::orient2d(a.x, a.y, b.x, b.y, c.x, c.y);
}

Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const filter::Estimate estimate = filter::orient3d(a, b, c, d);
  if (estimate.certain()) return estimate.sign();
  std::size_t exact_calls = 0;
  return detail::orient3d_after_filter(a, b, c, d, exact_calls);
}

Sign in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const filter::Estimate estimate = filter::in_circle(a, b, c, d);
  return estimate.certain() ? estimate.sign() : exact::in_circle(a, b, c, d);
}

Sign in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const filter::Estimate estimate = filter::in_sphere(a, b, c, d, e);
  if (estimate.certain()) return estimate.sign();
  std::size_t exact_calls = 0;
  return detail::in_sphere_after_filter(a, b, c, d, e, exact_calls);
}

bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) {
  return orient2d(Vec2{a.x, a.y}, Vec2{b.x, b.y}, Vec2{c.x, c.y}) == Sign::zero &&
         orient2d(Vec2{a.y, a.z}, Vec2{b.y, b.z}, Vec2{c.y, c.z}) == Sign::zero &&
         orient2d(Vec2{a.z, a.x}, Vec2{b.z, b.x}, Vec2{c.z, c.x}) == Sign::zero;
}

int compare_lexicographic(const Vec3& a, const Vec3& b) {
  for (std::size_t i = 0; i < 3; ++i)
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  return 0;
}

// Range of coordinates for which the predicates are exact. The longest products are those of in_sphere, with five
// differences. Let every nonzero coordinate lie in [2^-148, 2^148). Then each is a multiple of 2^-200, so are all
// differences, and each product of five is a multiple of 2^-1000. Therefore nothing underflows, because the least
// double is 2^-1074 and the factor of the error bounds is above 2^-50. Nothing overflows either, because no sum exceeds
// 2^8 * (2^149)^5 < 2^1000, including Veltkamp's splitting (times 2^27).
bool exponents_are_safe(std::span<const Vec3> points) {
  constexpr double smallest = 0x1p-148, limit = 0x1p148;
  auto safe = [](double x) { return x == 0 || (std::fabs(x) >= smallest && std::fabs(x) < limit); };
  for (const Vec3& p : points)
    if (!safe(p.x) || !safe(p.y) || !safe(p.z)) return false;
  return true;
}

}  // namespace geomesh
