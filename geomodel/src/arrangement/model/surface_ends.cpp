// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/model/surface_ends.hpp"

#include <algorithm>
#include <tuple>

namespace geomesh::geomodel::arrangement {

namespace {

auto place(const SurfaceEnd& e) { return std::tie(e.a, e.b, e.surface); }

/// Calls visit(a, b, surface, facet) for each edge (a, b), a < b, of each facet and each of the facet's surfaces.
template <class Visit>
void for_each_surface_edge(const Complex& complex, Visit visit) {
  for (Index f = 0; f < complex.facets.size(); ++f) {
    const Triangle& t = complex.facets[f];
    Index last = no_index;  // a facet's origins (input triangles) are grouped by surface
    for (const Origin& o : complex.origins.of(f)) {
      if (o.surface == last) continue;
      last = o.surface;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
        visit(a, b, o.surface, f);
      }
    }
  }
}

/// Returns the edges of all facets, once for each surface of the facet, sorted by edge and then by surface.
std::vector<SurfaceEnd> surface_edges(const Complex& complex) {
  std::vector<std::size_t> begin(complex.points.size() + 1, 0);
  for_each_surface_edge(complex, [&](VertexIndex a, VertexIndex, Index, Index) { ++begin[a + 1]; });
  for (std::size_t v = 0; v < complex.points.size(); ++v) begin[v + 1] += begin[v];
  std::vector<SurfaceEnd> all(begin.back());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for_each_surface_edge(complex, [&](VertexIndex a, VertexIndex b, Index surface, Index facet) {
    all[next[a]++] = {a, b, surface, facet};
  });
  for (std::size_t v = 0; v < complex.points.size(); ++v)
    std::sort(all.begin() + static_cast<std::ptrdiff_t>(begin[v]),
              all.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]),
              [](const SurfaceEnd& x, const SurfaceEnd& y) { return place(x) < place(y); });
  return all;
}

/// Calls see(first, count) for each edge of each surface, with one of the surface's facets there and their number.
template <class See>
void for_each_group(const std::vector<SurfaceEnd>& all, See see) {
  for (std::size_t i = 0, j; i < all.size(); i = j) {
    for (j = i + 1; j < all.size() && place(all[j]) == place(all[i]);) ++j;
    see(all[i], j - i);
  }
}

}  // namespace

std::vector<SurfaceEnd> surface_ends(const Complex& complex) {
  std::vector<SurfaceEnd> ends;
  for_each_group(surface_edges(complex), [&](const SurfaceEnd& first, std::size_t n) {
    if (n == 1) ends.push_back(first);
  });
  return ends;
}

std::vector<Index> branching_surfaces(const Complex& complex) {
  std::vector<Index> surfaces;
  for_each_group(surface_edges(complex), [&](const SurfaceEnd& first, std::size_t n) {
    if (n >= 3) surfaces.push_back(first.surface);
  });
  std::sort(surfaces.begin(), surfaces.end());
  surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
  return surfaces;
}

}  // namespace geomesh::geomodel::arrangement
