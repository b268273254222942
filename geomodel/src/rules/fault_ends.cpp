// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/fault_ends.hpp"

#include <array>
#include <string>
#include <vector>

#include "rules/extend/extend.hpp"

namespace geomesh::geomodel {
namespace {

std::array<Vec3, 3> corners_of(const TriangulatedSurface& s, std::size_t t) {
  const Triangle& v = s.triangles[t];
  return {s.points[v[0]], s.points[v[1]], s.points[v[2]]};
}

/// Returns whether some part of the triangle lies in the box, by clipping it.
bool reaches_into(const Box3& box, const std::array<Vec3, 3>& t) {
  std::vector<Vec3> polygon(t.begin(), t.end());
  for (std::size_t k = 0; k < 3; ++k)
    for (const bool at_max : {false, true}) {
      std::vector<Vec3> kept;
      const auto inside = [&](const Vec3& p) { return at_max ? box.max[k] - p[k] : p[k] - box.min[k]; };
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double dp = inside(p), dq = inside(q);
        if (dp >= 0) kept.push_back(p);
        if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) kept.push_back(p + (dp / (dp - dq)) * (q - p));
      }
      polygon = std::move(kept);
    }
  return polygon.size() > 2;
}

}  // namespace

Index continue_fault(TriangulatedSurface& fault, const Box3& box, const Box3& reach) {
  const TriangulatedSurface given = fault;
  std::vector<std::string> notes, warnings;
  extend_to_box(fault, Extend::flat, reach, {notes, warnings});
  for (std::size_t t = given.triangles.size(); t < fault.triangles.size(); ++t)
    if (reaches_into(box, corners_of(fault, t))) return static_cast<Index>(given.triangles.size());
  fault = given;
  return static_cast<Index>(given.triangles.size());
}

}  // namespace geomesh::geomodel
