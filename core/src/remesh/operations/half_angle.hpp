// SPDX-License-Identifier: MIT
/// @file
/// What bounds the shapes of two cells that share the dihedral angle of one.
#pragma once

#include <algorithm>
#include <cmath>

#include "geomesh/core/geometry.hpp"

namespace geomesh::remesh {

/// The sine of half of the angle that cell (a, b, x, y) has at its edge (x, y): not less; NaN where a face has no area.
/// Where two cells take the cell's place there, the worse of them is at most of that shape.
inline double sine_of_half_angle(const Vec3& a, const Vec3& b, const Vec3& x, const Vec3& y) {
  constexpr double rounding = 1e-6;
  const Vec3 d = y - x, m = cross(d, a - x), n = cross(d, b - x);
  const double cosine = dot(m, n) / std::sqrt(dot(m, m) * dot(n, n));
  return std::sqrt(std::max(0.5 - 0.5 * cosine, 0.0)) + rounding;
}

}  // namespace geomesh::remesh
