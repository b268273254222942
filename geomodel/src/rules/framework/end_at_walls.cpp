// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/framework/end_at_walls.hpp"

#include <algorithm>
#include <set>

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
      : surface_(surface),
        part_(part),
        merged_(merge_equal_points(surface.points)),
        first_(working.origins.size() + 1) {
    for (Index f = 0; f < working.origins.size(); ++f) {
      first_[f] = static_cast<Index>(triangle_.size());
      for (const Origin& o : working.origins[f])
        if (o.surface == row) triangle_.push_back(o.triangle);
    }
    first_.back() = static_cast<Index>(triangle_.size());
    joined_ = UnionFind(triangle_.size() + 1);  // the last: what was given
    for (Index k = 0; k < triangle_.size(); ++k)
      if (part_[triangle_[k]] == 0) joined_.unite(k, given());
  }

  /// Joins the facets that meet at one edge.
  void join(std::span<const EdgeUse> edge) {
    here_.clear();
    for (const EdgeUse& use : edge)
      for (Index k = first_[use.facet]; k < first_[use.facet + 1]; ++k) here_.push_back(k);
    for (std::size_t i = 0; i < here_.size(); ++i)
      for (std::size_t j = i + 1; j < here_.size(); ++j)
        if (hang_together(triangle_[here_[i]], triangle_[here_[j]])) joined_.unite(here_[i], here_[j]);
  }

  bool is_cut_off(Index facet, Index triangle) {
    for (Index k = first_[facet]; k < first_[facet + 1]; ++k)
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

  const TriangulatedSurface& surface_;
  const std::vector<Index>& part_;
  std::vector<VertexIndex> merged_;
  std::vector<Index> first_;     ///< per facet
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
  for_each_edge(working.uses, [&](std::span<const EdgeUse> edge) {
    const bool is_at_wall = std::any_of(edge.begin(), edge.end(), [&](const EdgeUse& use) {
      return std::any_of(working.origins[use.facet].begin(), working.origins[use.facet].end(),
                         [&](const Origin& o) { return std::binary_search(walls.begin(), walls.end(), o.surface); });
    });
    if (!is_at_wall) facets.join(edge);
  });
  double removed = 0;
  for (Index f = 0; f < working.origins.size(); ++f)
    removed += working.remove({f}, [&](const Origin& o) {
      return o.surface == row && part[o.triangle] != 0 && facets.is_cut_off(f, o.triangle);
    });
  return removed;
}

}  // namespace geomesh::geomodel
