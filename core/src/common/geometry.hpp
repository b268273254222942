// SPDX-License-Identifier: MIT
/// @file
/// Lengths, angles and areas in doubles. They never decide topology, which is the task of the predicates.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

using std::numbers::pi;
inline constexpr double degrees_per_radian = 180 / pi;

constexpr double squared_length(const Vec3& v) { return dot(v, v); }
constexpr double squared_distance(const Vec3& a, const Vec3& b) { return dot(a - b, a - b); }
inline double length(const Vec3& v) { return std::sqrt(dot(v, v)); }
inline double distance(const Vec3& a, const Vec3& b) { return length(a - b); }

/// Returns the unit vector in the direction of v; the zero vector is unchanged.
inline Vec3 unit(const Vec3& v) {
  const double l = length(v);
  return l > 0 ? (1 / l) * v : v;
}

/// Returns the normal of a triangle, whose length is twice the triangle's area.
constexpr Vec3 triangle_normal(const Vec3& a, const Vec3& b, const Vec3& c) { return cross(b - a, c - a); }

/// Returns the normal of a polygon by Newell's method. The length of the normal is twice the area of the polygon.
inline Vec3 loop_normal(std::span<const Vec3> points, std::span<const VertexIndex> loop) {
  Vec3 n;
  const Vec3& o = points[loop[0]];
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) n = n + cross(points[loop[i]] - o, points[loop[i + 1]] - o);
  return n;
}

constexpr std::array<VertexIndex, 2> sorted(std::array<VertexIndex, 2> e) {
  if (e[0] > e[1]) std::swap(e[0], e[1]);
  return e;
}
constexpr Triangle sorted(Triangle t) {
  if (t[0] > t[1]) std::swap(t[0], t[1]);
  if (t[1] > t[2]) std::swap(t[1], t[2]);
  if (t[0] > t[1]) std::swap(t[0], t[1]);
  return t;
}

}  // namespace geomesh
