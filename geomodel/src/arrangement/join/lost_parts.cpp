// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/join/lost_parts.hpp"

#include <algorithm>
#include <map>

#include "geomesh/core/surface_distance.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

constexpr double nothing = 1e-3;      // of the distance
constexpr double most_on_edge = 256;  // places

/// A surface that lost facets: the vanished ones, and those that it still has.
struct Surface {
  std::vector<const VanishedFacet*> vanished;
  std::vector<Triangle> left;
};

std::map<Index, Surface> surfaces_that_lost(std::span<const VanishedFacet> vanished, const Complex& complex) {
  std::map<Index, Surface> surfaces;
  for (const VanishedFacet& v : vanished)
    for (const Index s : v.surfaces) surfaces[s].vanished.push_back(&v);
  if (surfaces.empty()) return surfaces;
  for (Index f = 0; f < complex.facets.size(); ++f)
    for (const Index s : surfaces_of(complex.origins.of(f)))
      if (const auto at = surfaces.find(s); at != surfaces.end()) at->second.left.push_back(complex.facets[f]);
  return surfaces;
}

Displacement extent_of(const std::vector<const VanishedFacet*>& vanished) {
  Box3 box;
  for (const VanishedFacet* v : vanished)
    for (const Vec3& p : v->corners) box.add(p);
  return {length(box.max - box.min), 0, box.min, 0};
}

/// Records the place on the edges of a vanished facet that is farthest from the remaining facets of its surface.
void note_farthest(const VanishedFacet& facet, const SurfaceDistance& left, double step, Displacement& lost) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = facet.corners[k], along = facet.corners[(k + 1) % 3] - a;
    const double n = std::clamp(length(along) / step, 1.0, most_on_edge);
    for (double i = 0; i < n; ++i) {
      const Vec3 p = a + (i / n) * along;
      const double far = length(p - left.closest(p));
      if (far > lost.largest) lost = {far, 0, p, 0};
    }
  }
}

}  // namespace

Displacement lost_with(std::span<const VanishedFacet> vanished, const Complex& complex, double distance) {
  Displacement lost;
  for (const auto& [row, surface] : surfaces_that_lost(vanished, complex)) {
    if (surface.left.empty()) {
      const Displacement extent = extent_of(surface.vanished);
      if (extent.largest > lost.largest) lost = extent;
      continue;
    }
    const SurfaceDistance left(complex.points, surface.left);
    for (const VanishedFacet* facet : surface.vanished) note_farthest(*facet, left, distance, lost);
  }
  return lost.largest > nothing * distance ? lost : Displacement{};
}

}  // namespace geomesh::geomodel::arrangement
