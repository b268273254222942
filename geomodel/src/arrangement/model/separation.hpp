// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Rejects pairs of triangles early in the narrow phase. Most triangles whose boxes meet are neighbours in one surface
/// and nearly coplanar. Their planes separate them only in exact arithmetic; in projection along the normal they are
/// side by side.
#pragma once

#include <array>
#include <cmath>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel::arrangement {

/// Returns the sign of twice the area of the triangle abc if doubles prove it (Shewchuk 1997, bound A), else zero.
inline int proven_turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x), det = left - right;
  const double bound = 3.3306690738754716e-16 * (std::fabs(left) + std::fabs(right)) + 1e-290;
  return det > bound ? 1 : det < -bound ? -1 : 0;
}

/// Returns true if the line of an edge of one triangle proves that the other meets it only in shared vertices or edges.
/// Both are projected along the axis nearest to the normal of `a`. False means that nothing was proven.
inline bool proven_apart(const std::array<const Vec3*, 3>& pa, const Triangle& a, const std::array<const Vec3*, 3>& pb,
                         const Triangle& b) {
  const Vec3 n = cross(*pa[1] - *pa[0], *pa[2] - *pa[0]);
  std::size_t axis = std::fabs(n.x) >= std::fabs(n.y) ? 0 : 1;
  if (std::fabs(n.z) > std::fabs(n[axis])) axis = 2;
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  std::array<Vec2, 3> qa, qb;
  for (std::size_t k = 0; k < 3; ++k) {
    qa[k] = {(*pa[k])[i], (*pa[k])[j]};
    qb[k] = {(*pb[k])[i], (*pb[k])[j]};
  }
  const auto edge_separates = [](const std::array<Vec2, 3>& q, const Triangle& t, const std::array<Vec2, 3>& other,
                                 const Triangle& u) {
    const int turn = proven_turn(q[0], q[1], q[2]);
    if (turn == 0) return false;
    for (std::size_t e = 0; e < 3; ++e) {
      const std::size_t f = e == 2 ? 0 : e + 1;
      std::size_t k = 0;
      while (k < 3 && (u[k] == t[e] || u[k] == t[f] || proven_turn(q[e], q[f], other[k]) == -turn)) ++k;
      if (k == 3) return true;
    }
    return false;
  };
  return edge_separates(qa, a, qb, b) || edge_separates(qb, b, qa, a);
}

}  // namespace geomesh::geomodel::arrangement
