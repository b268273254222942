// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/diagnosis/surface_parts.hpp"

#include <algorithm>
#include <map>

#include "arrangement/diagnosis/edge_buckets.hpp"
#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

SurfaceParts::SurfaceParts(const PolygonSoup& soup, std::size_t n_surfaces)
    : parent_(soup.origins.size()), area_(soup.origins.size(), 0), shared_of_(n_surfaces), parts_of_(n_surfaces) {
  for (Index k = 0; k < parent_.size(); ++k) parent_[k] = k;
  EdgeBuckets(soup).for_each_edge(
      [&](VertexIndex, VertexIndex, const std::vector<Index>& facets) { add_edge(soup, facets); });
  for (Index f = 0; f < soup.facets.size(); ++f) {
    const auto& [a, b, c] = soup.facets[f];
    for (Index k = soup.origin_offsets[f]; k < soup.origin_offsets[f + 1]; ++k) {
      area_[root(k)] += area(soup.points[a], soup.points[b], soup.points[c]);
      if (root(k) == k) parts_of_[soup.origins[k].surface].push_back(k);
    }
  }
  for (Index e = 0; e < shared_.size(); ++e) {
    for (auto& [surface, part] : shared_[e]) part = root(part);
    std::sort(shared_[e].begin(), shared_[e].end());
    shared_[e].erase(std::unique(shared_[e].begin(), shared_[e].end()), shared_[e].end());
    for (std::size_t k = 0; k < shared_[e].size(); ++k)
      if (k == 0 || shared_[e][k].first != shared_[e][k - 1].first) shared_of_[shared_[e][k].first].push_back(e);
  }
}

Index SurfaceParts::root(Index node) const {
  while (parent_[node] != node) node = parent_[node];
  return node;
}

/// The lesser row stands; paths are halved on the way.
void SurfaceParts::unite(Index a, Index b) {
  for (Index* node : {&a, &b})
    while (parent_[*node] != *node) *node = parent_[*node] = parent_[parent_[*node]];
  parent_[std::max(a, b)] = std::min(a, b);
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
  for (std::size_t k = 1; k < at.size(); ++k) unite(at[0].second, at[k].second);
}

double SurfaceParts::area_parted(Index a, Index b) const {
  std::map<Index, Index> joined;
  for (const Index part : parts_of_[a]) joined[part] = part;
  const auto find = [&joined](Index part) {
    while (joined.at(part) != part) part = joined.at(part) = joined.at(joined.at(part));
    return part;
  };
  for (const Index e : shared_of_[a]) {
    const SharedEdge& edge = shared_[e];
    if (std::any_of(edge.begin(), edge.end(), [&](const auto& entry) { return entry.first == b; })) continue;
    Index first = no_index;
    for (const auto& [surface, part] : edge) {
      if (surface != a) continue;
      if (first == no_index) first = find(part);
      const Index other = find(part);
      joined[std::max(first, other)] = std::min(first, other);
      first = std::min(first, other);
    }
  }
  std::map<Index, double> areas;
  for (const Index part : parts_of_[a]) areas[find(part)] += area_[part];
  double all = 0, largest = 0;
  for (const auto& [part, size] : areas) {
    all += size;
    largest = std::max(largest, size);
  }
  return areas.size() > 1 ? all - largest : 0;
}

}  // namespace geomesh::geomodel::arrangement
