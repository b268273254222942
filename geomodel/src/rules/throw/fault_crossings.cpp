// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/throw/fault_crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "arrangement/search/bvh.hpp"
#include "common/by_rounding.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel {
namespace {

Box3 bounds_of(const std::array<Vec3, 3>& t) {
  Box3 box;
  for (const Vec3& p : t) box.add(p);
  return box;
}

/// Returns whether box `a` reaches into the model's box by more than rounding. A fault that ends on a side of the
/// model's box has no end inside, so nothing continues around it.
bool reaches_into(const Box3& a, const Box3& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double room = std::isfinite(box.max[k] - box.min[k]) ? by_rounding * (box.max[k] - box.min[k]) : 0;
    if (a.max[k] <= box.min[k] + room || box.max[k] - room <= a.min[k]) return false;
  }
  return true;
}

std::array<Vec3, 3> corners_of(const TriangulatedSurface& s, std::size_t t) {
  const Triangle& v = s.triangles[t];
  return {s.points[v[0]], s.points[v[1]], s.points[v[2]]};
}

/// Returns whether the segment meets the triangle. Touching it counts; lying in its plane does not.
bool crosses(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& t) {
  const Sign sp = orient3d(t[0], t[1], t[2], p), sq = orient3d(t[0], t[1], t[2], q);
  if (sp == sq) return false;
  bool positive = false, negative = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Sign side = orient3d(p, q, t[i], t[(i + 1) % 3]);
    positive = positive || side == Sign::positive;
    negative = negative || side == Sign::negative;
  }
  return !(positive && negative);
}

/// Returns the point, rounded, at which the segment crosses the triangle.
Vec3 crossing_point(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& t) {
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  const double dp = dot(p - t[0], n), dq = dot(q - t[0], n);
  return dp == dq ? p : p + (dp / (dp - dq)) * (q - p);
}

}  // namespace

bool ends_inside(const ThrowFault& fault, const Box3& box) {
  for (std::size_t t = fault.first_made; t < fault.surface->triangles.size(); ++t)
    if (reaches_into(bounds_of(corners_of(*fault.surface, t)), box)) return true;
  return false;
}

std::vector<Crossing> find_crossings(const TriangulatedSurface& horizon, std::size_t first,
                                     const std::vector<ThrowFault>& faults, const Box3& box) {
  const std::size_t n = horizon.triangles.size() - first;
  std::vector<Crossing> found(n, Crossing::none);
  std::vector<Box3> bounds(n);
  for (std::size_t k = 0; k < n; ++k) bounds[k] = bounds_of(corners_of(horizon, first + k));
  const arrangement::BoxTree tree(bounds);
  for (const ThrowFault& fault : faults) {
    std::vector<Box3> met(n);  // boxes of the places at which the border of each triangle meets the fault's extension
    for (Index f = 0; f < fault.surface->triangles.size(); ++f) {
      const std::array<Vec3, 3> of_fault = corners_of(*fault.surface, f);
      const Box3 around = bounds_of(of_fault);
      tree.boxes_meeting(around, [&](Index k) {
        const std::array<Vec3, 3> t = corners_of(horizon, first + k);
        for (std::size_t i = 0; i < 3; ++i) {
          const Vec3 &p = t[i], &q = t[(i + 1) % 3];
          if (!crosses(p, q, of_fault)) continue;
          if (f >= fault.first_made) {
            met[k].add(crossing_point(p, q, of_fault));
          } else if (found[k] == Crossing::none) {
            found[k] = Crossing::fault;
          }
        }
      });
    }
    for (std::size_t k = 0; k < n; ++k)
      if (!met[k].empty() && reaches_into(met[k], box)) found[k] = Crossing::continuation;
  }
  return found;
}

}  // namespace geomesh::geomodel
