// SPDX-License-Identifier: MIT
/// @file
/// Circumcentres in floating point, as candidates for new points. No topological decision depends on them.
#pragma once

#include <optional>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

/// Returns the circumcentre of the triangle in its plane, or nothing if its points are (nearly) collinear.
inline std::optional<Vec3> circumcentre(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a, n = cross(u, v);
  const double nn = dot(n, n);
  if (!(nn > 0)) return std::nullopt;
  return a + (0.5 / nn) * (dot(v, v) * cross(n, u) + dot(u, u) * cross(v, n));
}

/// Returns the circumcentre of the tetrahedron, or nothing if its points are (nearly) coplanar.
inline std::optional<Vec3> circumcentre(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const double det = dot(cross(u, v), w);
  if (det == 0) return std::nullopt;
  return a + (0.5 / det) * (dot(u, u) * cross(v, w) + dot(v, v) * cross(w, u) + dot(w, w) * cross(u, v));
}

}  // namespace geomesh
