// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/diagnosis/surface_parts.hpp"

#include <algorithm>
#include <map>

#include "arrangement/diagnosis/edge_buckets.hpp"
#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

SurfaceParts::SurfaceParts(const PolygonSoup& soup, std::size_t n_surfaces)
    : joined_(soup.origins.size()), area_(soup.origins.size(), 0), shared_of_(n_surfaces), parts_of_(n_surfaces) {
  EdgeBuckets(soup).for_each_edge(
      [&](VertexIndex, VertexIndex, const std::vector<Index>& facets) { add_edge(soup, facets); });
  for (Index f = 0; f < soup.facets.size(); ++f) {
    const auto& [a, b, c] = soup.facets[f];
    for (Index k = soup.origin_offsets[f]; k < soup.origin_offsets[f + 1]; ++k) {
      area_[joined_.find(k)] += area(soup.points[a], soup.points[b], soup.points[c]);
      if (joined_.find(k) == k) parts_of_[soup.origins[k].surface].push_back(k);
    }
  }
  for (Index e = 0; e < shared_.size(); ++e) {
    for (auto& [surface, part] : shared_[e]) part = joined_.find(part);
    std::sort(shared_[e].begin(), shared_[e].end());
    shared_[e].erase(std::unique(shared_[e].begin(), shared_[e].end()), shared_[e].end());
    for (std::size_t k = 0; k < shared_[e].size(); ++k)
      if (k == 0 || shared_[e][k].first != shared_[e][k - 1].first) shared_of_[shared_[e][k].first].push_back(e);
  }
}

void SurfaceParts::add_edge(const PolygonSoup& soup, const std::vector<Index>& facets) {
  SharedEdge at;
  for (const Index f : facets)
    for (Index k = soup.origin_offsets[f]; k < soup.origin_offsets[f + 1]; ++k)
      at.emplace_back(soup.origins[k].surface, k);
  const bool alone =
      std::all_of(at.begin(), at.end(), [&](const auto& entry) { return entry.first == at.front().first; });
  if (!alone) {
    shared_.push_back(std::move(at));
    return;
  }
  for (std::size_t k = 1; k < at.size(); ++k) joined_.unite(at[0].second, at[k].second);
}

double SurfaceParts::area_parted(Index a, Index b) const {
  const std::vector<Index>& parts = parts_of_[a];
  const auto row_of = [&parts](Index part) {
    return static_cast<Index>(std::lower_bound(parts.begin(), parts.end(), part) - parts.begin());
  };
  UnionFind joined(parts.size());
  for (const Index e : shared_of_[a]) {
    const SharedEdge& edge = shared_[e];
    if (std::any_of(edge.begin(), edge.end(), [&](const auto& entry) { return entry.first == b; })) continue;
    Index first = no_index;
    for (const auto& [surface, part] : edge) {
      if (surface != a) continue;
      if (first == no_index) first = row_of(part);
      joined.unite(first, row_of(part));
    }
  }
  std::map<Index, double> areas;
  for (Index row = 0; row < parts.size(); ++row) areas[joined.find(row)] += area_[parts[row]];
  double all = 0, largest = 0;
  for (const auto& [part, size] : areas) {
    all += size;
    largest = std::max(largest, size);
  }
  return areas.size() > 1 ? all - largest : 0;
}

}  // namespace geomesh::geomodel::arrangement
