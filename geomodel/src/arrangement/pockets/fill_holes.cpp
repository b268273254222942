// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/pockets/fill_holes.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "arrangement/model/surface_ends.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

/// Returns the origin (input triangle) of an adjacent surface for facet t, oriented as t continues that surface.
Origin origin_beside(const Complex& complex, const SurfaceEnd& end, const Triangle& t) {
  const auto of = complex.origins.of(end.facet);
  const Origin& own = *std::find_if(of.begin(), of.end(), [&](const Origin& o) { return o.surface == end.surface; });
  return carried_over(own, complex.facets[end.facet], t, end.a, end.b);
}

/// Largest length of the open edge of a hole's facet, relative to the sum of its two other edges.
constexpr double mouth_of_notch = 0.125;

class Holes {
 public:
  Holes(const Complex& complex, double distance)
      : complex_(complex), height_(2 * distance), ends_(surface_ends(complex)) {}

  /// Returns for each facet that fills a hole the origins (input triangles) that it receives.
  std::map<Index, std::vector<Origin>> find() const {
    std::map<Index, std::vector<Origin>> found;
    for (Index f = 0; f < complex_.facets.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        for (auto at = first_end_at(f, k, 0); at != ends_.end() && is_at(*at, f, k); ++at)
          if (is_low(f) && fills(f, k, *at)) add(found[f], origin_beside(complex_, *at, complex_.facets[f]));
    return found;
  }

 private:
  std::array<VertexIndex, 2> edge(Index f, std::size_t k) const {
    const Triangle& t = complex_.facets[f];
    const auto [a, b] = std::minmax(t[k % 3], t[(k + 1) % 3]);
    return {a, b};
  }
  double edge_length(Index f, std::size_t k) const {
    const auto [a, b] = edge(f, k);
    return length(complex_.points[b] - complex_.points[a]);
  }
  bool is_at(const SurfaceEnd& end, Index f, std::size_t k) const { return edge(f, k) == std::array{end.a, end.b}; }
  std::vector<SurfaceEnd>::const_iterator first_end_at(Index f, std::size_t k, Index surface) const {
    const auto [a, b] = edge(f, k);
    return std::lower_bound(ends_.begin(), ends_.end(), std::tuple(a, b, surface),
                            [](const SurfaceEnd& e, const auto& key) { return std::tie(e.a, e.b, e.surface) < key; });
  }
  bool ends_at(Index f, std::size_t k, Index surface) const {
    const auto at = first_end_at(f, k, surface);
    return at != ends_.end() && is_at(*at, f, k) && at->surface == surface && at->facet != f;
  }
  bool is_low(Index f) const {
    const auto& [a, b, c] = complex_.facets[f];
    const double longest = std::max({edge_length(f, 0), edge_length(f, 1), edge_length(f, 2)});
    return 2 * area(complex_.points[a], complex_.points[b], complex_.points[c]) <= height_ * longest;
  }
  /// Returns whether facet f fills a hole in the surface that ends (`end`) at edge k of f. This surface must also end
  /// at the next edge of f, and either end at the third edge as well, or the third edge must be short.
  bool fills(Index f, std::size_t k, const SurfaceEnd& end) const {
    if (end.facet == f || !ends_at(f, k + 1, end.surface)) return false;
    if (ends_at(f, k + 2, end.surface)) return true;
    const double mouth = edge_length(f, k + 2);
    return mouth <= height_ && mouth < mouth_of_notch * (edge_length(f, k) + edge_length(f, k + 1));
  }
  static void add(std::vector<Origin>& origins, const Origin& origin) {
    if (std::none_of(origins.begin(), origins.end(), [&](const Origin& o) { return o.surface == origin.surface; }))
      origins.push_back(origin);
  }

  const Complex& complex_;
  double height_;  ///< largest height of a facet that fills a hole
  std::vector<SurfaceEnd> ends_;
};

}  // namespace

std::size_t fill_holes(Complex& complex, double distance) {
  const std::map<Index, std::vector<Origin>> more = Holes(complex, distance).find();
  if (more.empty()) return 0;
  edit_origins(complex, [&](Index f, std::vector<Origin>& of) {
    if (const auto at = more.find(f); at != more.end()) of.insert(of.end(), at->second.begin(), at->second.end());
  });
  return more.size();
}

}  // namespace geomesh::geomodel::arrangement
