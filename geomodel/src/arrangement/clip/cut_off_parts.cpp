// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/clip/cut_off_parts.hpp"

#include <algorithm>
#include <array>

#include "arrangement/clip/clip.hpp"
#include "common/union_find.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

/// The facets of one surface; a facet that several triangles of the surface share is counted once for each of them.
class PartFacets {
 public:
  PartFacets(const FacetsWithOrigins& of, const SurfaceInParts& in) : of_(of), in_(in) {
    for (Index f = 0; f < of.facets.size(); ++f) {
      const std::size_t before = triangle_.size();
      for (const PolygonSoup::Origin& o : of.origins_of(f))
        if (o.surface == in.row) triangle_.push_back(o.triangle);
      if (triangle_.size() == before) continue;
      facets_.push_back(f);
      first_.push_back(static_cast<Index>(before));
    }
    first_.push_back(static_cast<Index>(triangle_.size()));
    // The last entry of the union-find stands for the surface's original part, as opposed to its continuations.
    joined_ = UnionFind(triangle_.size() + 1);
    for (Index k = 0; k < triangle_.size(); ++k)
      if (in.part[triangle_[k]] == 0) joined_.unite(k, given());
  }

  /// Unites facets across edges at which no bounding surface lies.
  void join() {
    std::vector<std::array<VertexIndex, 2>> edges;
    for (const Index f : facets_)
      for (unsigned i = 0; i < 3; ++i) {
        const Triangle& t = of_.facets[f];
        edges.push_back({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
      }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& [a, b] : edges) {
      const auto first = std::lower_bound(of_.uses.begin(), of_.uses.end(), EdgeUse{a, b, 0});
      auto last = first;
      while (last != of_.uses.end() && last->a == a && last->b == b) ++last;
      const std::span edge(std::span(of_.uses).subspan(static_cast<std::size_t>(first - of_.uses.begin()),
                                                       static_cast<std::size_t>(last - first)));
      if (!is_at_wall(edge)) join_at(edge);
    }
  }

  std::vector<std::pair<Index, Index>> cut_off() {
    std::vector<std::pair<Index, Index>> found;
    for (std::size_t i = 0; i < facets_.size(); ++i)
      for (Index k = first_[i]; k < first_[i + 1]; ++k)
        if (in_.part[triangle_[k]] != 0 && joined_.find(k) != joined_.find(given()))
          found.emplace_back(facets_[i], triangle_[k]);
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  Index given() const { return static_cast<Index>(triangle_.size()); }
  bool is_at_wall(std::span<const EdgeUse> edge) const {
    return std::any_of(edge.begin(), edge.end(), [&](const EdgeUse& use) {
      const auto origins = of_.origins_of(use.facet);
      return std::any_of(origins.begin(), origins.end(), [&](const PolygonSoup::Origin& o) {
        return std::binary_search(in_.walls.begin(), in_.walls.end(), o.surface) &&
               !in_.lost.contains({use.facet, o.surface, o.triangle});
      });
    });
  }
  void join_at(std::span<const EdgeUse> edge) {
    here_.clear();
    for (const EdgeUse& use : edge) {
      const auto at = std::lower_bound(facets_.begin(), facets_.end(), use.facet);
      if (at == facets_.end() || *at != use.facet) continue;
      const auto i = static_cast<std::size_t>(at - facets_.begin());
      for (Index k = first_[i]; k < first_[i + 1]; ++k) here_.push_back(k);
    }
    for (std::size_t i = 0; i < here_.size(); ++i)
      for (std::size_t j = i + 1; j < here_.size(); ++j)
        if (hang_together(triangle_[here_[i]], triangle_[here_[j]])) joined_.unite(here_[i], here_[j]);
  }
  bool hang_together(Index s, Index t) const {
    if (in_.part[s] == in_.part[t]) return true;
    if (in_.part[s] != 0 && in_.part[t] != 0) return false;
    for (const VertexIndex v : in_.surface.triangles[s])
      for (const VertexIndex w : in_.surface.triangles[t])
        if (v == w) return true;
    return false;
  }

  const FacetsWithOrigins& of_;
  const SurfaceInParts& in_;
  std::vector<Index> facets_;    ///< ascending
  std::vector<Index> first_;     ///< for each facet in facets_: index of its first entry in triangle_
  std::vector<Index> triangle_;  ///< of the surface
  UnionFind joined_{0};
  std::vector<Index> here_;
};

}  // namespace

std::vector<std::pair<Index, Index>> parts_cut_off(const FacetsWithOrigins& of, const SurfaceInParts& in) {
  PartFacets facets(of, in);
  facets.join();
  return facets.cut_off();
}

void end_continuations(ClipContext context, const ArrangementOptions& options) {
  Arranged& arranged = context.arranged;
  const auto kind_of = [&](Index row) { return context.surfaces[row].kind; };
  std::vector<Index> rows;
  for (Index row = 0; row < options.ends_at.size(); ++row)
    if (!options.ends_at[row].empty() && !options.parts[row].empty()) rows.push_back(row);
  if (rows.empty()) return;
  std::stable_partition(rows.begin(), rows.end(), [&](Index row) { return kind_of(row) == SurfaceKind::fault; });
  const std::vector<EdgeUse> uses = sorted_edge_uses(arranged.facets);
  const auto origins_of = [&](Index f) { return arranged.origins.of(f); };
  LostParts lost;
  std::vector<std::uint8_t> which(arranged.facets.size(), 0);
  for (const Index row : rows) {
    const auto cut_off = parts_cut_off({arranged.facets, uses, origins_of},
                                       {context.surfaces[row], row, options.parts[row], options.ends_at[row], lost});
    for (const auto& [facet, triangle] : cut_off) {
      lost.insert({facet, row, triangle});
      if (kind_of(row) != SurfaceKind::fault) which[facet] = 1;
    }
  }
  remove_origins(arranged, which, [&](Index f, const Origin& o) {
    return kind_of(o.surface) != SurfaceKind::fault && lost.contains({f, o.surface, o.triangle});
  });
}

}  // namespace geomesh::geomodel::arrangement
