// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/snap/slits.hpp"

#include <algorithm>
#include <span>
#include <tuple>

namespace geomesh::geomodel::arrangement {

namespace {

/// An edge, the lesser end first, a surface and a facet of it there.
using SurfaceEdge = std::tuple<VertexIndex, VertexIndex, Index, Index>;

bool are_of_one_surface(const SurfaceEdge& x, const SurfaceEdge& y) {
  return std::tie(std::get<0>(x), std::get<1>(x), std::get<2>(x)) ==
         std::tie(std::get<0>(y), std::get<1>(y), std::get<2>(y));
}

/// Where surfaces end.
std::vector<SurfaceEdge> ends_of(const Complex& complex) {
  std::vector<SurfaceEdge> all;
  for (Index f = 0; f < complex.facets.size(); ++f) {
    const Triangle& t = complex.facets[f];
    Index last = no_index;  // origins of one surface follow each other
    for (const Origin& o : complex.origins.of(f)) {
      if (o.surface == last) continue;
      last = o.surface;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
        all.emplace_back(a, b, o.surface, f);
      }
    }
  }
  std::sort(all.begin(), all.end());
  std::vector<SurfaceEdge> ends;
  for (std::size_t i = 0, j; i < all.size(); i = j) {
    for (j = i + 1; j < all.size() && are_of_one_surface(all[i], all[j]);) ++j;
    if (j == i + 1) ends.push_back(all[i]);
  }
  return ends;
}

/// Facets by vertex.
class FacetsAt {
 public:
  explicit FacetsAt(const Complex& complex) : first_(complex.points.size() + 1, 0) {
    for (const Triangle& t : complex.facets)
      for (const VertexIndex v : t) ++first_[v + 1];
    for (std::size_t v = 0; v < complex.points.size(); ++v) first_[v + 1] += first_[v];
    facets_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (Index f = 0; f < complex.facets.size(); ++f)
      for (const VertexIndex v : complex.facets[f]) facets_[next[v]++] = f;
  }
  std::span<const Index> of(VertexIndex v) const { return {facets_.data() + first_[v], first_[v + 1] - first_[v]}; }

 private:
  std::vector<std::size_t> first_;
  std::vector<Index> facets_;
};

/// Between the ends of an edge, and as near to it as that.
bool is_beside(const Vec3& p, const Vec3& a, const Vec3& b, double distance) {
  const Vec3 edge = b - a, off = p - a;
  const double squared = dot(edge, edge), along = dot(off, edge);
  if (!(along > 0 && along < squared)) return false;
  const Vec3 across = off - (along / squared) * edge;
  return dot(across, across) < distance * distance;
}

}  // namespace

void mark_slits(const Complex& complex, double distance, std::vector<std::uint8_t>& active) {
  const FacetsAt facets_at(complex);
  for (const auto& [a, b, surface, f] : ends_of(complex)) {
    const Triangle& own = complex.facets[f];
    for (const VertexIndex v : own)
      for (const Index g : facets_at.of(v))
        for (const VertexIndex w : complex.facets[g])
          if (std::find(own.begin(), own.end(), w) == own.end() &&
              is_beside(complex.points[w], complex.points[a], complex.points[b], distance))
            active[f] = active[g] = 1;
  }
}

}  // namespace geomesh::geomodel::arrangement
