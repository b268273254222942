// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/snap/cracks.hpp"

#include <algorithm>
#include <span>

#include "arrangement/model/surface_ends.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

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

/// Returns whether the point p is between the ends of an edge and within the distance of it.
bool is_beside(const Vec3& p, const Vec3& a, const Vec3& b, double distance) {
  const Vec3 edge = b - a, off = p - a;
  const double squared = dot(edge, edge), along = dot(off, edge);
  if (!(along > 0 && along < squared)) return false;
  const Vec3 across = off - (along / squared) * edge;
  return dot(across, across) < distance * distance;
}

}  // namespace

void mark_cracks(const Complex& complex, double distance, std::vector<std::uint8_t>& active) {
  const FacetsAt facets_at(complex);
  for (const SurfaceEnd& end : surface_ends(complex)) {
    const Vec3 &a = complex.points[end.a], &b = complex.points[end.b];
    const Triangle& own = complex.facets[end.facet];
    for (const VertexIndex v : own)
      for (const Index g : facets_at.of(v))
        for (const VertexIndex w : complex.facets[g])
          if (std::find(own.begin(), own.end(), w) == own.end() && is_beside(complex.points[w], a, b, distance))
            active[end.facet] = active[g] = 1;
  }
}

}  // namespace geomesh::geomodel::arrangement
