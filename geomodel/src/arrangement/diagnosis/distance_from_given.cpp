// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/diagnosis/distance_from_given.hpp"

#include <algorithm>
#include <map>

#include "geomesh/core/surface_distance.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

constexpr double beyond_corners = 1.01;  ///< what a facet may be off over what its corners are
constexpr double of_model = 1e-6;        ///< of the diagonal: where hardly anything moved

/// Facets by the surface that they are part of.
std::map<Index, std::vector<Index>> facets_by_surface(const Complex& complex, std::size_t n_given) {
  std::map<Index, std::vector<Index>> facets;
  for (Index f = 0; f < complex.facets.size(); ++f)
    for (const Origin& o : complex.origins.of(f)) {
      std::vector<Index>& of = facets[o.surface];
      if (o.surface < n_given && (of.empty() || of.back() != f)) of.push_back(f);
    }
  return facets;
}

}  // namespace

std::optional<Displacement> distance_from_given(const Complex& complex, const std::vector<TriangulatedSurface>& given) {
  Displacement found;
  Box3 box;
  for (const Vec3& p : complex.points) box.add(p);
  const auto by_surface = facets_by_surface(complex, given.size());
  std::map<Index, SurfaceDistance> distances;
  for (const auto& [surface, facets] : by_surface) {
    if (facets.empty()) continue;
    const SurfaceDistance& to =
        distances.try_emplace(surface, given[surface].points, given[surface].triangles).first->second;
    for (const Index f : facets)
      for (const VertexIndex v : complex.facets[f]) {
        const double moved = length(to.closest(complex.points[v]) - complex.points[v]);
        if (moved > found.largest) found.largest = moved, found.where = complex.points[v];
      }
  }
  found.largest = std::max(beyond_corners * found.largest, of_model * length(box.max - box.min));
  for (const auto& [surface, facets] : by_surface)
    for (const Index f : facets) {
      const Triangle& t = complex.facets[f];
      const std::array corners{complex.points[t[0]], complex.points[t[1]], complex.points[t[2]]};
      if (!distances.at(surface).is_within(corners, found.largest)) return std::nullopt;
    }
  return found;
}

}  // namespace geomesh::geomodel::arrangement
