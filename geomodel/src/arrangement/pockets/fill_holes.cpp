// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/pockets/fill_holes.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "arrangement/model/surface_ends.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

/// The surface's origin of the facet beside, turned as the surface goes on over the edge to `t`.
Origin origin_beside(const Complex& complex, const SurfaceEnd& end, const Triangle& t) {
  const auto of = complex.origins.of(end.facet);
  const Origin& own = *std::find_if(of.begin(), of.end(), [&](const Origin& o) { return o.surface == end.surface; });
  return carried_over(own, complex.facets[end.facet], t, end.a, end.b);
}

bool is_low(const Complex& complex, const Triangle& t, double height) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, length(complex.points[t[(k + 1) % 3]] - complex.points[t[k]]));
  return 2 * area(complex.points[t[0]], complex.points[t[1]], complex.points[t[2]]) <= height * longest;
}

/// By facet the origins that fill holes.
std::map<Index, std::vector<Origin>> find_holes(const Complex& complex, double distance) {
  const std::vector<SurfaceEnd> ends = surface_ends(complex);
  const auto ends_from = [&](VertexIndex a, VertexIndex b, Index surface) {
    return std::lower_bound(ends.begin(), ends.end(), std::tuple(std::min(a, b), std::max(a, b), surface),
                            [](const SurfaceEnd& e, const auto& key) { return std::tie(e.a, e.b, e.surface) < key; });
  };
  std::map<Index, std::vector<Origin>> found;
  for (Index f = 0; f < complex.facets.size(); ++f) {
    const Triangle& t = complex.facets[f];
    const auto ends_at = [&](std::size_t k, const SurfaceEnd& first) {
      const auto at = ends_from(t[k], t[(k + 1) % 3], first.surface);
      const bool is_same = at != ends.end() && std::minmax(t[k], t[(k + 1) % 3]) == std::minmax(at->a, at->b) &&
                           at->surface == first.surface;
      return is_same && at->facet != f;
    };
    for (auto at = ends_from(t[0], t[1], 0); at != ends.end() && std::minmax(at->a, at->b) == std::minmax(t[0], t[1]);
         ++at)
      if (ends_at(0, *at) && ends_at(1, *at) && ends_at(2, *at) && is_low(complex, t, 2 * distance))
        found[f].push_back(origin_beside(complex, *at, t));
  }
  return found;
}

}  // namespace

std::size_t fill_holes(Complex& complex, double distance) {
  const std::map<Index, std::vector<Origin>> more = find_holes(complex, distance);
  if (more.empty()) return 0;
  edit_origins(complex, [&](Index f, std::vector<Origin>& of) {
    if (const auto at = more.find(f); at != more.end()) of.insert(of.end(), at->second.begin(), at->second.end());
  });
  return more.size();
}

}  // namespace geomesh::geomodel::arrangement
