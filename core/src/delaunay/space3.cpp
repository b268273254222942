// SPDX-License-Identifier: MIT
#include "delaunay/space3.hpp"

#include <algorithm>
#include <bit>

namespace geomesh {
namespace {

/// Compares like compare_lexicographic, but without branches, which would be mispredicted for ties on lattices.
int compare(const Vec3& a, const Vec3& b) {
  return 4 * ((a.x > b.x) - (a.x < b.x)) + 2 * ((a.y > b.y) - (a.y < b.y)) + ((a.z > b.z) - (a.z < b.z));
}

}  // namespace

bool Space3::finite_conflict_after_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& p,
                                          double value) {
  if (exact_reach_ > 0) {
    const std::array<Vec3, 4> r{a - p, b - p, c - p, d - p};
    double reach = 0;
    for (const Vec3& u : r) reach = filter::max4(reach, std::fabs(u.x), std::fabs(u.y), std::fabs(u.z));
    if (reach <= exact_reach_) return value != 0 ? value > 0 : near_tie_conflict(r);
  }
  const Sign s = detail::in_sphere_after_filter(a, b, c, d, p, exact_calls_);
  return s != Sign::zero ? s == Sign::positive : tie_conflict(a, b, c, d, p);
}

/// Decides a tie of four points whose differences r from p are at most 512 units. The lexicographic order of the points
/// is then the order of one exact number each, which is 0 for p. Orientations are plain determinants.
bool Space3::near_tie_conflict(const std::array<Vec3, 4>& r) {
  std::array<double, 4> place;
  for (unsigned i = 0; i < 4; ++i) place[i] = 0x1p22 * r[i].x + 0x1p11 * r[i].y + r[i].z;
  for (unsigned attempt = 0; attempt < 4; ++attempt) {
    const unsigned low = place[1] > place[0] ? 1 : 0, high = place[3] > place[2] ? 3 : 2;
    const unsigned g = place[high] > place[low] ? high : low;
    if (place[g] < 0) return false;
    const Vec3 &u = r[g == 0 ? 1 : 0], &v = r[g <= 1 ? 2 : 1], &w = r[g <= 2 ? 3 : 2];
    const double det = dot(u, cross(v, w));
    if (det != 0) return (det > 0) == (g % 2 == 0);
    place[g] = -0x1p1000;
  }
  return false;
}

/// Decides a tie of the in-sphere test like detail::in_sphere_tie. Instead of sorting the points it selects the
/// greatest remaining one, because the first nearly always decides.
bool Space3::tie_conflict(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& p) {
  const std::array<const Vec3*, 4> v{&a, &b, &c, &d};
  for (unsigned left = 0b1111; left != 0;) {
    unsigned greatest = static_cast<unsigned>(std::countr_zero(left));
    for (unsigned i = greatest + 1; i < 4; ++i)
      if (left >> i & 1u) greatest = compare(*v[i], *v[greatest]) > 0 ? i : greatest;
    if (compare(p, *v[greatest]) > 0) return false;
    std::array<const Vec3*, 4> with_p = v;
    with_p[greatest] = &p;
    const Sign s = orientation(*with_p[0], *with_p[1], *with_p[2], *with_p[3]);
    if (s != Sign::zero) return s == Sign::positive;
    left &= ~(1u << greatest);
  }
  return false;
}

double coordinate_unit(std::span<const Vec3> points) {
  int least = 2000, greatest = -2000;
  for (const Vec3& p : points)
    for (const double x : {p.x, p.y, p.z}) {
      if (x == 0) continue;
      const auto bits = std::bit_cast<std::uint64_t>(x);
      const int exponent = static_cast<int>(bits >> 52 & 0x7FF) - 1023;
      const std::uint64_t mantissa = (bits & 0xFFFFFFFFFFFFFull) | 1ull << 52;
      least = std::min(least, exponent - 52 + std::countr_zero(mantissa));
      greatest = std::max(greatest, exponent);
      if (greatest - least > 40) return 0;
    }
  return least == 2000 ? 0 : std::ldexp(1.0, least);
}

}  // namespace geomesh
