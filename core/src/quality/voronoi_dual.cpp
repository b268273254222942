// SPDX-License-Identifier: MIT
#include "geomesh/core/voronoi_dual.hpp"

#include <algorithm>

#include "common/geometry.hpp"
#include "geomesh/core/dual_faces.hpp"

namespace geomesh {

VoronoiDual measure_voronoi_dual(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra) {
  VoronoiDual dual;
  for (const DualFace& face : dual_faces(points, tetrahedra)) {
    const double relative = face.area / squared_distance(points[face.a], points[face.b]);
    dual.least = dual.edges == 0 ? relative : std::min(dual.least, relative);
    ++dual.edges;
    if (relative >= -1e-12) continue;
    ++dual.negative;
    dual.negative_on_border += face.on_border;
  }
  return dual;
}

}  // namespace geomesh
