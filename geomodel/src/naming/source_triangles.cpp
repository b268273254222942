// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/source_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "naming/region_facts.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {

namespace {

std::array<Vec3, 3> corners_of(const TriangulatedSurface& surface, Index triangle) {
  const Triangle& t = surface.triangles[triangle];
  return {surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]};
}

/// Returns a bound on the distance by which rounding may move p off its triangle.
double rounding_at(const Vec3& p) {
  constexpr double of_coordinates = 1e-12;
  return of_coordinates * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

}  // namespace

Index SourceTriangles::of(Index facet, const Vec3& p) {
  const PolygonSoup::Origin& origin = origins_of(meshed_.soup, meshed_.plc, facet).front();
  const ModelPlc& plc = meshed_.plc;
  if (plc.facet_soup_offsets[facet + 1] - plc.facet_soup_offsets[facet] > 1) return under(p, facet);
  if (plc.plc.n_loops(facet) > 1 || plc.plc.outer_loop(facet).size() > 3)
    return origin.triangle;  // The facet is a polygon that was read from a file.
  const double most = meshed_.moved_at_most + rounding_at(p);
  if (!(distance_from(p, origin.surface, origin.triangle) > most)) return origin.triangle;
  return search_in(origin.surface).closest_triangle(p);
}

Index SourceTriangles::under(const Vec3& p, Index facet) {
  const Index surface = origins_of(meshed_.soup, meshed_.plc, facet).front().surface;
  std::vector<Index>& candidates = candidates_[facet];
  if (candidates.empty()) candidates = triangles_of(facet);
  Index best = candidates.front();
  double best_excess = std::numeric_limits<double>::infinity();
  for (Index triangle : candidates) {
    const auto [a, b, c] = corners_of(meshed_.surfaces[surface], triangle);
    const double excess =
        triangle_area(p, a, b) + triangle_area(p, b, c) + triangle_area(p, c, a) - triangle_area(a, b, c);
    if (excess < best_excess) {
      best_excess = excess;
      best = triangle;
    }
  }
  return best;
}

std::vector<Index> SourceTriangles::triangles_of(Index facet) const {
  const PolygonSoup& soup = meshed_.soup;
  const ModelPlc& plc = meshed_.plc;
  std::set<Index> triangles;
  for (Index i = plc.facet_soup_offsets[facet]; i < plc.facet_soup_offsets[facet + 1]; ++i)
    triangles.insert(soup.origins[soup.origin_offsets[plc.facet_soup[i]]].triangle);
  return {triangles.begin(), triangles.end()};
}

double SourceTriangles::distance_from(const Vec3& p, Index surface, Index triangle) const {
  return norm(p - closest_on_triangle(p, corners_of(meshed_.surfaces[surface], triangle)));
}

const SurfaceDistance& SourceTriangles::search_in(Index surface) {
  const auto at = searches_.find(surface);
  if (at != searches_.end()) return at->second;
  const TriangulatedSurface& s = meshed_.surfaces[surface];
  return searches_.emplace(surface, SurfaceDistance(s.points, s.triangles)).first->second;
}

}  // namespace geomesh::geomodel
