// SPDX-License-Identifier: MIT
// Breaks ties of in_circle and in_sphere (Devillers and Teillaud 2011, section 4). The lifted height of point i is
// increased by e_i, where e_i is much larger than e_j if i is lexicographically greater than j. The sign of the
// perturbed determinant is then determined by the greatest point whose cofactor does not vanish. That cofactor is the
// orientation of the other points.
#include <algorithm>
#include <array>
#include <cmath>

#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"
#include "predicates/exact_stage.hpp"

namespace geomesh {
namespace {

/// Returns the positions 0..N-1 of the points, lexicographically greatest first.
template <std::size_t N>
std::array<std::size_t, N> greatest_first(const std::array<const Vec3*, N>& points) {
  std::array<std::size_t, N> order;
  for (std::size_t i = 0; i < N; ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return compare_lexicographic(*points[i], *points[j]) > 0; });
  return order;
}

Vec2 drop_axis(const Vec3& p, int axis) {
  return axis == 0 ? Vec2{p.y, p.z} : axis == 1 ? Vec2{p.z, p.x} : Vec2{p.x, p.y};
}

/// Decides the tie of four cocircular points a, b, c and d for any planar orientation function. `orientation` is the
/// orientation of a, b and c, which is not zero.
template <class Point, class Orient>
Sign in_circle_tie(const std::array<std::size_t, 4>& order, const std::array<const Point*, 4>& points, Orient orient,
                   Sign orientation) {
  for (std::size_t i : order) {
    if (i == 3) return Sign::negative;
    std::array<const Point*, 3> with_d{points[0], points[1], points[2]};
    with_d[i] = points[3];
    const Sign s = orient(*with_d[0], *with_d[1], *with_d[2]);
    if (s != Sign::zero) return s * orientation;
  }
  return Sign::negative;
}

}  // namespace

namespace detail {

Sign in_sphere_tie(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const std::array<const Vec3*, 5> points{&a, &b, &c, &d, &e};
  for (std::size_t i : greatest_first(points)) {
    if (i == 4) return Sign::negative;
    std::array<const Vec3*, 4> with_e{&a, &b, &c, &d};
    with_e[i] = &e;
    const Sign s = orient3d(*with_e[0], *with_e[1], *with_e[2], *with_e[3]);
    if (s != Sign::zero) return s;
  }
  return Sign::negative;
}

}  // namespace detail

Sign in_circle_perturbed(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const Sign s = in_circle(a, b, c, d);
  if (s != Sign::zero) return s;
  const Vec3 a3{a.x, a.y, 0}, b3{b.x, b.y, 0}, c3{c.x, c.y, 0}, d3{d.x, d.y, 0};
  const auto order = greatest_first<4>({&a3, &b3, &c3, &d3});
  return in_circle_tie<Vec2>(order, {&a, &b, &c, &d}, orient2d, Sign::positive);
}

Sign in_sphere_perturbed(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e) {
  const Sign s = in_sphere(a, b, c, d, e);
  return s != Sign::zero ? s : detail::in_sphere_tie(a, b, c, d, e);
}

Sign in_circle_coplanar_perturbed(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  int axis = 0;
  Sign orientation = Sign::zero;
  for (; axis < 3; ++axis) {
    orientation = orient2d(drop_axis(a, axis), drop_axis(b, axis), drop_axis(c, axis));
    if (orientation != Sign::zero) break;
  }
  GEOMESH_CHECK(orientation != Sign::zero);
  // Any sphere through a, b, c and a point q off their plane intersects the plane in the circumcircle of a, b and c. As
  // q serves the point a moved along the dropped axis, which is not parallel to the plane. It is moved by about the
  // size of the triangle so that the filters succeed.
  Vec3 q = a;
  const auto k = static_cast<std::size_t>(axis);
  const double size = std::max({std::fabs(b.x - a.x), std::fabs(b.y - a.y), std::fabs(b.z - a.z)});
  q[k] = a[k] + size;
  if (q[k] == a[k]) q[k] = a[k] == 0 ? 1 : 2 * a[k];
  const Sign side = orient3d(a, b, c, q);
  const Sign s = side == Sign::positive ? in_sphere(a, b, c, q, d) : in_sphere(b, a, c, q, d);
  if (s != Sign::zero) return s;
  const auto orient = [axis](const Vec3& u, const Vec3& v, const Vec3& w) {
    return orient2d(drop_axis(u, axis), drop_axis(v, axis), drop_axis(w, axis));
  };
  const auto order = greatest_first<4>({&a, &b, &c, &d});
  return in_circle_tie<Vec3>(order, {&a, &b, &c, &d}, orient, orientation);
}

}  // namespace geomesh
