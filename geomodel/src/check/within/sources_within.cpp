// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that mesh faces are near the input triangles that they name as sources, declared in
// check/within/within_tolerance.hpp.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "check/mesh/faults.hpp"
#include "check/within/within_tolerance.hpp"

namespace geomesh::geomodel::checking {
namespace {

double distance(const Vec3& p, const Vec3& q) { return std::sqrt(dot(q - p, q - p)); }

double distance_of_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Corners first{a, b, b}, second{c, d, d};
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& p : {a, b}) least = std::min(least, distance(p, nearest_on_triangle(p, second)));
  for (const Vec3& p : {c, d}) least = std::min(least, distance(p, nearest_on_triangle(p, first)));
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), whole = uu * vv - uv * uv;
  if (!(whole > 0)) return least;
  const double s = (uv * dot(v, w) - vv * dot(u, w)) / whole, t = (uu * dot(v, w) - uv * dot(u, w)) / whole;
  return s > 0 && s < 1 && t > 0 && t < 1 ? std::min(least, distance(a + s * u, c + t * v)) : least;
}

/// Returns the distance between the triangle t and the point where the segment a b crosses the triangle's plane.
double distance_at_plane(const Vec3& a, const Vec3& b, const Corners& t) {
  const Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
  const double from = dot(a - t[0], normal), to = dot(b - t[0], normal);
  if (!(from * to < 0)) return std::numeric_limits<double>::infinity();
  const Vec3 p = a + (from / (from - to)) * (b - a);
  return distance(p, nearest_on_triangle(p, t));
}

/// Returns the distance of two triangles, attained at a corner, between two sides, or where a side crosses the other.
double gap_between(const Corners& a, const Corners& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &p = (*from)[i], &q = (*from)[(i + 1) % 3];
      least = std::min({least, distance(p, nearest_on_triangle(p, *to)), distance_at_plane(p, q, *to)});
    }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      least = std::min(least, distance_of_segments(a[i], a[(i + 1) % 3], b[k], b[(k + 1) % 3]));
  return least;
}

}  // namespace

void check_sources_within(const CheckedFaces& checked, const Allowed& allowed, CheckResult& result) {
  FaultCollector no_source("wrong_source_triangles"), off("faces_off_their_triangle");
  const FacesFile& faces = *checked.faces();
  double farthest = 0;
  for (Index f = 0; f < checked.candidates().size(); ++f) {
    const Index row = checked.surface_of(faces.surface[f]);
    if (row == no_index) continue;
    const TriangulatedSurface& surface = checked.specification().surfaces[row];
    const Corners face = corners_of(checked, f);
    const auto source = static_cast<std::size_t>(faces.source_triangle[f]);
    if (faces.source_triangle[f] < 0 || source >= surface.triangles.size()) {
      no_source.add(f, face[0]);
      continue;
    }
    const Triangle& t = surface.triangles[source];
    const double gap = gap_between(face, {surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]});
    farthest = std::max(farthest, gap);
    if (gap > 2 * allowed.both()) off.add(f, face[0]);
  }
  no_source.report(result, "faces name a source_triangle that their surface does not have");
  char text[140];
  std::snprintf(text, sizeof text,
                "faces lie nowhere near the input triangle that they name (%.3g off, where %.3g may be)", farthest,
                2 * allowed.both());
  off.report(result, text);
}

}  // namespace geomesh::geomodel::checking
