// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/exact/crossing.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "check/exact/exact.hpp"

namespace geomesh::geomodel::checking {
namespace {

bool opposite(Sign a, Sign b) { return a * b == Sign::negative; }

/// Returns whether r, which is known to be on the line p q, lies between them (ends included). Projected along `axis`.
bool between(const Vec3& p, const Vec3& q, const Vec3& r, int axis) {
  for (std::size_t i = 0; i < 3; ++i)
    if (static_cast<int>(i) != axis && (r[i] < std::min(p[i], q[i]) || r[i] > std::max(p[i], q[i]))) return false;
  return true;
}

/// Returns whether the closed segments p q and r s meet in the projection along `axis`.
bool segments_meet(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, int axis) {
  const Sign pr = projected_orientation(p, q, r, axis), ps = projected_orientation(p, q, s, axis);
  const Sign rp = projected_orientation(r, s, p, axis), rq = projected_orientation(r, s, q, axis);
  if (opposite(pr, ps) && opposite(rp, rq)) return true;
  return (pr == Sign::zero && between(p, q, r, axis)) || (ps == Sign::zero && between(p, q, s, axis)) ||
         (rp == Sign::zero && between(r, s, p, axis)) || (rq == Sign::zero && between(r, s, q, axis));
}

/// Returns whether p lies in the closed triangle a b c in the projection along `axis`.
bool inside_projected(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
  const Sign s0 = projected_orientation(a, b, p, axis), s1 = projected_orientation(b, c, p, axis),
             s2 = projected_orientation(c, a, p, axis);
  return !opposite(s0, s1) && !opposite(s1, s2) && !opposite(s0, s2);
}

/// Returns whether the closed segment p q meets the closed triangle a b c (not degenerate, projectable along `axis`).
bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c, int axis) {
  const Sign sp = orientation(a, b, c, p), sq = orientation(a, b, c, q);
  if (sp * sq == Sign::positive) return false;
  if (sp == Sign::zero && sq == Sign::zero)
    return inside_projected(p, a, b, c, axis) || segments_meet(p, q, a, b, axis) || segments_meet(p, q, b, c, axis) ||
           segments_meet(p, q, c, a, axis);
  const Sign s0 = orientation(p, q, a, b), s1 = orientation(p, q, b, c), s2 = orientation(p, q, c, a);
  return !opposite(s0, s1) && !opposite(s1, s2) && !opposite(s0, s2);
}

/// Corners of two triangles, reordered so that the corners they share come first and in the same order.
struct Shared {
  Triangle s, t;
  int n = 0;
};
Shared sort_shared(Triangle s, Triangle t) {
  Shared shared;
  for (int i = 0; i < 3; ++i)
    for (int j = shared.n; j < 3; ++j)
      if (s[i] == t[j]) {
        std::swap(s[shared.n], s[i]);
        std::swap(t[shared.n], t[j]);
        ++shared.n;
        break;
      }
  shared.s = s;
  shared.t = t;
  return shared;
}

/// Returns +1 or -1 if the ray from the centroid of c crosses the triangle p q r from its back or its front, else 0.
/// The ray points along +axis, or along -axis if `up` is false. Sets `on` if the centroid lies on the triangle p q r.
int ray_crossing(const std::array<Vec3, 3>& t, const std::array<Vec3, 3>& c, int axis, bool up, bool& on) {
  const Sign s0 = centroid_side(c[0], c[1], c[2], t[0], t[1], axis),
             s1 = centroid_side(c[0], c[1], c[2], t[1], t[2], axis),
             s2 = centroid_side(c[0], c[1], c[2], t[2], t[0], axis);
  if (s0 == Sign::zero || s0 != s1 || s1 != s2) return 0;
  // With axes in cyclic order, the normal's component along `axis` has the sign of the triangle's projected area.
  const Sign side = centroid_orientation(t[0], t[1], t[2], c[0], c[1], c[2]);
  if (side == Sign::zero) {
    on = true;
    return 0;
  }
  const bool above = side == s0;  // whether the ray's start, the centroid of c, is on the +axis side of the plane of t
  if (above == up) return 0;
  const bool leaves_along_normal = (s0 == Sign::positive) == up;
  return leaves_along_normal ? 1 : -1;
}

/// Returns a box that contains the ray from the triangle's centroid, enlarged because the centroid is rounded.
Box3 ray_box(const std::array<Vec3, 3>& c, int axis, bool up) {
  Box3 box;
  const Vec3 m = (1.0 / 3) * (c[0] + c[1] + c[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    const double room = 4e-15 * (std::abs(c[0][i]) + std::abs(c[1][i]) + std::abs(c[2][i])) + 1e-300;
    box.min[i] = m[i] - room;
    box.max[i] = m[i] + room;
  }
  const double infinity = std::numeric_limits<double>::infinity();
  (up ? box.max : box.min)[static_cast<std::size_t>(axis)] = up ? infinity : -infinity;
  return box;
}

}  // namespace

Meeting meeting(const std::vector<Vec3>& points, const Triangle& s, const Triangle& t) {
  const Shared shared = sort_shared(s, t);
  const auto p = [&](int i) -> const Vec3& { return points[shared.s[i]]; };
  const auto q = [&](int i) -> const Vec3& { return points[shared.t[i]]; };
  const int axis_s = projection_axis(p(0), p(1), p(2)), axis_t = projection_axis(q(0), q(1), q(2));
  if (axis_s < 0 || axis_t < 0) return Meeting::proper;
  if (shared.n == 3) return Meeting::overlap;
  if (shared.n == 2) {
    if (orientation(p(0), p(1), p(2), q(2)) != Sign::zero) return Meeting::proper;
    return opposite(projected_orientation(p(0), p(1), p(2), axis_s), projected_orientation(p(0), p(1), q(2), axis_s))
               ? Meeting::proper
               : Meeting::overlap;
  }
  bool meet = false;
  if (shared.n == 1) {
    meet = segment_meets_triangle(p(1), p(2), q(0), q(1), q(2), axis_t) ||
           segment_meets_triangle(q(1), q(2), p(0), p(1), p(2), axis_s);
  } else {
    for (int i = 0; i < 3 && !meet; ++i)
      meet = segment_meets_triangle(p(i), p((i + 1) % 3), q(0), q(1), q(2), axis_t) ||
             segment_meets_triangle(q(i), q((i + 1) % 3), p(0), p(1), p(2), axis_s);
  }
  if (!meet) return Meeting::proper;
  for (int i = 0; i < 3; ++i)
    if (orientation(p(0), p(1), p(2), q(i)) != Sign::zero) return Meeting::crossing;
  return Meeting::overlap;
}

int winding_outside(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, Index f,
                    const BoxTree& tree) {
  const std::array<Vec3, 3> c{points[triangles[f][0]], points[triangles[f][1]], points[triangles[f][2]]};
  const int axis = projection_axis(c[0], c[1], c[2]);
  if (axis < 0) return 0;
  const bool up = projected_orientation(c[0], c[1], c[2], axis) == Sign::positive;
  int winding = 0;
  bool on = false;
  tree.query(ray_box(c, axis, up), [&](Index g) {
    if (g == f) return;
    winding +=
        ray_crossing({points[triangles[g][0]], points[triangles[g][1]], points[triangles[g][2]]}, c, axis, up, on);
  });
  return winding;
}

std::optional<int> winding_about_centroid(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                                          const BoxTree& tree, const Vec3& a, const Vec3& b, const Vec3& c) {
  int winding = 0;
  bool on = false;
  const std::array<Vec3, 3> m{a, b, c};
  tree.query(ray_box(m, 2, true), [&](Index g) {
    winding +=
        ray_crossing({points[triangles[g][0]], points[triangles[g][1]], points[triangles[g][2]]}, m, 2, true, on);
  });
  if (on) return std::nullopt;
  return winding;
}

}  // namespace geomesh::geomodel::checking
