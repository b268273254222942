// SPDX-License-Identifier: GPL-3.0-or-later
#include "complex.hpp"

#include <cmath>

#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel::arrangement {

Projection projection_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  std::size_t k = std::fabs(n.x) >= std::fabs(n.y) ? 0 : 1;
  if (std::fabs(n.z) > std::fabs(n[k])) k = 2;
  for (std::size_t turn = 0; turn < 3; ++turn, k = (k + 1) % 3) {
    Projection frame{(k + 1) % 3, (k + 2) % 3, Sign::zero};
    frame.sign = orient2d(project(a, frame), project(b, frame), project(c, frame));
    if (frame.sign != Sign::zero) return frame;
  }
  return {};
}

double length(const Vec3& a) { return std::sqrt(dot(a, a)); }
double area(const Vec3& a, const Vec3& b, const Vec3& c) { return 0.5 * length(cross(b - a, c - a)); }

}  // namespace geomesh::geomodel::arrangement
