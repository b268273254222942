// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/throw/area_samples.hpp"

#include <limits>

#include "naming/sums.hpp"

namespace geomesh::geomodel {

Vec3 centre_of(const TriangulatedSurface& s, const Triangle& t) {
  return (1.0 / 3) * (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]);
}

double area_of(const TriangulatedSurface& s, Index t) {
  const Triangle& v = s.triangles[t];
  return triangle_area(s.points[v[0]], s.points[v[1]], s.points[v[2]]);
}

AreaSamples::AreaSamples(const TriangulatedSurface& surface) : surface_(surface) {
  constexpr double least_parts = 500;
  double all = 0;
  for (Index t = 0; t < surface.triangles.size(); ++t) all += area_of(surface, t);
  largest_ = all > 0 ? all / least_parts : std::numeric_limits<double>::infinity();
}

}  // namespace geomesh::geomodel
