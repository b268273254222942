// SPDX-License-Identifier: GPL-3.0-or-later
// Input triangles that faces name, declared in check/within/within_tolerance.hpp.
#include <algorithm>
#include <cmath>
#include <limits>

#include "check/judged/faults.hpp"
#include "check/within/within_tolerance.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Places on a triangle at thirds and quarters of its sides, its corners among them.
std::vector<Vec3> lattice_on(const Corners& t) {
  constexpr int n = 6;
  std::vector<Vec3> places;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j)
      places.push_back(t[0] + (double(i) / n) * (t[1] - t[0]) + (double(j) / n) * (t[2] - t[0]));
  return places;
}

/// The least distance from places on either triangle to the other one.
double gap_between(const Corners& a, const Corners& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const Vec3& p : lattice_on(*from)) {
      const Vec3 d = nearest_on_triangle(p, *to) - p;
      least = std::min(least, std::sqrt(dot(d, d)));
    }
  return least;
}

}  // namespace

void check_sources_within(const ClaimedFaces& claimed, const Allowed& allowed, CheckResult& result) {
  FaultCollector no_source("wrong_source_triangles"), off("faces_off_their_triangle");
  const FacesFile& faces = *claimed.faces();
  for (Index f = 0; f < claimed.candidates().size(); ++f) {
    const Index row = claimed.surface_of(faces.surface[f]);
    if (row == no_index) continue;
    const TriangulatedSurface& surface = claimed.claim().surfaces[row];
    const Corners face = corners_of(claimed, f);
    const auto source = static_cast<std::size_t>(faces.source_triangle[f]);
    if (faces.source_triangle[f] < 0 || source >= surface.triangles.size()) {
      no_source.add(f, face[0]);
      continue;
    }
    const Triangle& t = surface.triangles[source];
    if (gap_between(face, {surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]}) > 2 * allowed.both())
      off.add(f, face[0]);
  }
  no_source.report(result, "faces name a source_triangle that their surface does not have");
  off.report(result, "faces lie nowhere near the input triangle that they name");
}

}  // namespace geomesh::geomodel::checking
