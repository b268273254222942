// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/exact/plane_triangle.hpp"

#include <algorithm>
#include <cmath>

#include "check/exact/exact.hpp"

namespace geomesh::geomodel::checking {
namespace {

double norm(const Vec3& a) { return std::sqrt(dot(a, a)); }
double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Clips a convex polygon to the half-space in which `value` is not negative (Sutherland and Hodgman 1974).
template <class Point, class Value, class Blend>
std::vector<Point> clip(const std::vector<Point>& polygon, Value&& value, Blend&& blend) {
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double vp = value(p), vq = value(q);
    if (vp >= 0) kept.push_back(p);
    if ((vp > 0 && vq < 0) || (vp < 0 && vq > 0)) kept.push_back(blend(p, q, vp / (vp - vq)));
  }
  return kept;
}

}  // namespace

PlaneTriangle::PlaneTriangle(const Vec3& a, const Vec3& b, const Vec3& c) : corner_{a, b, c} {
  const Vec3 n = exact_normal(a, b, c);
  length_ = norm(n);
  if (length_ == 0) return;
  normal_ = (1 / length_) * n;
  Vec3 longest = b - a;
  if (norm(c - b) > norm(longest)) longest = c - b;
  if (norm(a - c) > norm(longest)) longest = a - c;
  axis_u_ = (1 / norm(longest)) * longest;
  axis_v_ = cross(normal_, axis_u_);
  for (int i = 0; i < 3; ++i) flat_[i] = project(corner_[i]);
}

double PlaneTriangle::perimeter() const {
  return norm(corner_[1] - corner_[0]) + norm(corner_[2] - corner_[1]) + norm(corner_[0] - corner_[2]);
}

Vec2 PlaneTriangle::project(const Vec3& p) const {
  const Vec3 d = p - corner_[0];
  return {dot(d, axis_u_), dot(d, axis_v_)};
}

double PlaneTriangle::distance(const Vec3& p) const {
  return std::abs(six_volumes(corner_[0], corner_[1], corner_[2], p)) / length_;
}

double PlaneTriangle::outside(const Vec3& p) const {
  const Vec2 f = project(p);
  double worst = 0;
  for (int i = 0; i < 3; ++i) {
    const Vec2 &a = flat_[i], &b = flat_[(i + 1) % 3];
    worst = std::max(worst, -turn(a, b, f) / std::hypot(b.x - a.x, b.y - a.y));
  }
  return worst;
}

bool PlaneTriangle::are_beyond_a_side(const Vec3& p, const Vec3& q, double tolerance) const {
  const Vec2 fp = project(p), fq = project(q);
  for (int i = 0; i < 3; ++i) {
    const Vec2 &a = flat_[i], &b = flat_[(i + 1) % 3];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (std::max(turn(a, b, fp), turn(a, b, fq)) <= tolerance * length) return true;
  }
  return false;
}

double PlaneTriangle::common_area(const Vec3& p, const Vec3& q, const Vec3& r) const {
  std::vector<Vec2> polygon{project(p), project(q), project(r)};
  const auto blend = [](const Vec2& a, const Vec2& b, double t) {
    return Vec2{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
  };
  for (int i = 0; i < 3; ++i) {
    const Vec2 a = flat_[i], b = flat_[(i + 1) % 3];
    polygon = clip(
        polygon, [&](const Vec2& x) { return turn(a, b, x); }, blend);
  }
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) twice += turn(polygon[0], polygon[i - 1], polygon[i]);
  return 0.5 * std::abs(twice);
}

std::vector<Vec3> PlaneTriangle::inside(const Box3& box) const {
  std::vector<Vec3> polygon(corner_.begin(), corner_.end());
  const auto blend = [](const Vec3& a, const Vec3& b, double t) { return a + t * (b - a); };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    polygon = clip(
        polygon, [&](const Vec3& x) { return x[axis] - box.min[axis]; }, blend);
    polygon = clip(
        polygon, [&](const Vec3& x) { return box.max[axis] - x[axis]; }, blend);
  }
  return polygon;
}

double PlaneTriangle::area_inside(const Box3& box) const {
  const std::vector<Vec3> polygon = inside(box);
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    twice += dot(cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]), normal_);
  return 0.5 * std::abs(twice);
}

}  // namespace geomesh::geomodel::checking
