// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/end_at_walls.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "common/union_find.hpp"
#include "naming/sheets.hpp"

namespace geomesh::geomodel {
namespace {

using Origin = PolygonSoup::Origin;

/// The facets of one continued surface, each counted once for each of the surface's triangles that it stands for.
class ContinuedFacets {
 public:
  ContinuedFacets(const WorkingSoup& working, const TriangulatedSurface& surface, const std::vector<Index>& part,
                  Index row)
      : working_(working), surface_(surface), part_(part), merged_(merge_equal_points(surface.points)) {
    for (Index f = 0; f < working.origins.size(); ++f) {
      const std::size_t before = triangle_.size();
      for (const Origin& o : working.origins[f])
        if (o.surface == row) triangle_.push_back(o.triangle);
      if (triangle_.size() == before) continue;
      facets_.push_back(f);
      first_.push_back(static_cast<Index>(before));
    }
    first_.push_back(static_cast<Index>(triangle_.size()));
    joined_ = UnionFind(triangle_.size() + 1);  // the last: what was given
    for (Index k = 0; k < triangle_.size(); ++k)
      if (part_[triangle_[k]] == 0) joined_.unite(k, given());
  }

  const std::vector<Index>& facets() const { return facets_; }  ///< ascending

  /// Visits each edge of these facets once, with all facets of the soup that meet there.
  template <class Visit>
  void for_each_edge(const Visit& visit) const {
    std::vector<std::array<VertexIndex, 2>> edges;
    for (const Index f : facets_)
      for (unsigned i = 0; i < 3; ++i) {
        const Triangle& t = working_.soup.facets[f];
        edges.push_back({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
      }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& [a, b] : edges) {
      const auto first = std::lower_bound(working_.uses.begin(), working_.uses.end(), EdgeUse{a, b, 0});
      auto last = first;
      while (last != working_.uses.end() && last->a == a && last->b == b) ++last;
      visit(std::span<const EdgeUse>(first, last));
    }
  }

  /// Joins the facets that meet at one edge.
  void join(std::span<const EdgeUse> edge) {
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

  /// `i`: position in facets().
  bool is_cut_off(std::size_t i, Index triangle) {
    for (Index k = first_[i]; k < first_[i + 1]; ++k)
      if (triangle_[k] == triangle) return joined_.find(k) != joined_.find(given());
    return false;
  }

 private:
  Index given() const { return static_cast<Index>(triangle_.size()); }
  bool hang_together(Index s, Index t) const {
    if (part_[s] == part_[t]) return true;
    if (part_[s] != 0 && part_[t] != 0) return false;
    for (const VertexIndex v : surface_.triangles[s])
      for (const VertexIndex w : surface_.triangles[t])
        if (merged_[v] == merged_[w]) return true;
    return false;
  }

  const WorkingSoup& working_;
  const TriangulatedSurface& surface_;
  const std::vector<Index>& part_;
  std::vector<VertexIndex> merged_;
  std::vector<Index> facets_;
  std::vector<Index> first_;     ///< per facet of these
  std::vector<Index> triangle_;  ///< of the surface
  UnionFind joined_{0};
  std::vector<Index> here_;
};

}  // namespace

double end_at_walls(WorkingSoup& working, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                    Index row) {
  const std::vector<Index>& part = built.part_of_triangle[row];
  const std::vector<Index>& walls = built.continued_to[row];
  ContinuedFacets facets(working, surfaces[row], part, row);
  facets.for_each_edge([&](std::span<const EdgeUse> edge) {
    const bool is_at_wall = std::any_of(edge.begin(), edge.end(), [&](const EdgeUse& use) {
      return std::any_of(working.origins[use.facet].begin(), working.origins[use.facet].end(),
                         [&](const Origin& o) { return std::binary_search(walls.begin(), walls.end(), o.surface); });
    });
    if (!is_at_wall) facets.join(edge);
  });
  double removed = 0;
  for (std::size_t i = 0; i < facets.facets().size(); ++i)
    removed += working.remove({facets.facets()[i]}, [&](const Origin& o) {
      return o.surface == row && part[o.triangle] != 0 && facets.is_cut_off(i, o.triangle);
    });
  return removed;
}

}  // namespace geomesh::geomodel
