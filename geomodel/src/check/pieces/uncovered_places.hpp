// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Points of an input triangle, on a lattice, that no mesh face covers.
#pragma once

#include <algorithm>
#include <vector>

#include "check/exact/plane_triangle.hpp"
#include "check/mesh/checked_faces.hpp"

namespace geomesh::geomodel::checking {

/// Points tested inside an input triangle are the nodes of a lattice with this number of intervals along each side.
inline constexpr int lattice_parts = 14;

inline std::vector<PlaneTriangle> flat_faces(const CheckedFaces& checked, const std::vector<Index>& faces) {
  std::vector<PlaneTriangle> flat;
  for (const Index f : faces) {
    const Triangle& t = checked.candidates()[f];
    flat.emplace_back(checked.corner(t, 0), checked.corner(t, 1), checked.corner(t, 2));
  }
  return flat;
}

inline bool is_covered(const Vec3& p, const std::vector<PlaneTriangle>& flat, double tolerance) {
  return std::ranges::any_of(flat,
                             [&](const PlaneTriangle& f) { return !f.degenerate() && f.outside(p) <= tolerance; });
}

/// Calls visit(point) for lattice points of an input triangle that no mesh face covers, until visit returns false.
template <class Visit>
void for_each_uncovered(const PlaneTriangle& triangle, const std::vector<PlaneTriangle>& flat, double tolerance,
                        Visit visit) {
  const auto& c = triangle.corners();
  for (int i = 1; i < lattice_parts; ++i)
    for (int j = 1; i + j < lattice_parts; ++j) {
      const double u = double(i) / lattice_parts, v = double(j) / lattice_parts;
      const Vec3 p = c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0]);
      if (!is_covered(p, flat, tolerance) && !visit(p)) return;
    }
}

}  // namespace geomesh::geomodel::checking
