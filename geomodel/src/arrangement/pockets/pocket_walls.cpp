// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/pockets/pocket_walls.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "common/union_find.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

// Smallest and largest fraction of a thin void's area that one of its two walls may have.
constexpr double least_part = 0.3, most_part = 0.7;

/// Calls see(edge, facets) for each edge of the facets, in ascending order.
template <class See>
void for_each_edge_of(const Complex& complex, const std::vector<FacetSide>& sides, const See& see) {
  std::vector<std::pair<EdgeKey, Index>> uses;
  uses.reserve(3 * sides.size());
  for (const FacetSide s : sides) {
    for (const EdgeKey& e : edges_of(complex.facets[facet_of(s)])) uses.emplace_back(e, facet_of(s));
  }
  std::sort(uses.begin(), uses.end());
  std::vector<Index> facets;
  for (std::size_t i = 0; i < uses.size();) {
    const EdgeKey edge = uses[i].first;
    facets.clear();
    for (; i < uses.size() && uses[i].first == edge; ++i) facets.push_back(uses[i].second);
    see(edge, facets);
  }
}

}  // namespace

double area_of(const Complex& complex, const std::vector<FacetSide>& sides) {
  double sum = 0;
  for (const FacetSide s : sides) {
    const Triangle& t = complex.facets[facet_of(s)];
    sum += area(complex.points[t[0]], complex.points[t[1]], complex.points[t[2]]);
  }
  return sum;
}

WallSearch::WallSearch(const Complex& complex, const EdgeFacets& edges, Index first_side)
    : complex_(complex),
      edges_(edges),
      first_side_(first_side),
      is_held_(complex.points.size(), 0),
      n_facets_at_(complex.points.size(), 0) {
  for (const auto& s : complex.segments) is_held_[s.a] = is_held_[s.b] = 1;
  for (const auto& p : complex.isolated_points) is_held_[p.v] = 1;
  for (const Triangle& t : complex.facets)
    for (const VertexIndex v : t) ++n_facets_at_[v];
}

std::optional<PocketWalls> WallSearch::of(const std::vector<FacetSide>& shell) const {
  const auto is_of_volume = [&](FacetSide s) {
    return surfaces_of(complex_.origins.of(facet_of(s))).back() >= first_side_;
  };
  if (std::any_of(shell.begin(), shell.end(), is_of_volume)) return std::nullopt;
  const double whole = area_of(complex_, shell);
  std::optional<PocketWalls> best;
  double best_part = 0;
  for (const std::vector<FacetSide>& wall : parts_of(shell)) {
    const double part = area_of(complex_, wall) / whole;
    if (part < least_part || part > most_part || !can_go(wall)) continue;
    if (best && std::abs(part - 0.5) >= std::abs(best_part - 0.5)) continue;
    best.emplace();
    best_part = part;
    best->that_goes = wall;
    std::set_difference(shell.begin(), shell.end(), wall.begin(), wall.end(), std::back_inserter(best->that_stays));
  }
  return best;
}

/// Returns the parts of a shell, the facet sides around a closed space: a part consists of facets of the same surfaces,
/// connected across edges to which nothing else is attached.
std::vector<std::vector<FacetSide>> WallSearch::parts_of(const std::vector<FacetSide>& shell) const {
  const auto row = [&](Index facet) {  // index of a facet in `shell`, the sorted facet sides around a closed space
    return static_cast<Index>(
        std::lower_bound(shell.begin(), shell.end(), facet, [](FacetSide s, Index f) { return facet_of(s) < f; }) -
        shell.begin());
  };
  UnionFind joined(shell.size());
  for_each_edge_of(complex_, shell, [&](const EdgeKey& e, const std::vector<Index>& at) {
    if (at.size() == 2 && is_free_inside(e.first, e.second) &&
        surfaces_of(complex_.origins.of(at[0])) == surfaces_of(complex_.origins.of(at[1])))
      joined.unite(row(at[0]), row(at[1]));
  });
  std::map<Index, std::vector<FacetSide>> parts;
  for (std::size_t k = 0; k < shell.size(); ++k) parts[joined.find(static_cast<Index>(k))].push_back(shell[k]);
  std::vector<std::vector<FacetSide>> all;
  for (auto& [root, part] : parts) all.push_back(std::move(part));
  return all;
}

/// Returns whether a wall of a thin void can be removed, because the vertices inside the wall belong to no other facet.
bool WallSearch::can_go(const std::vector<FacetSide>& wall) const {
  std::vector<VertexIndex> corners, on_rim;
  for (const FacetSide s : wall)
    for (const VertexIndex v : complex_.facets[facet_of(s)]) corners.push_back(v);
  std::sort(corners.begin(), corners.end());
  for_each_edge_of(complex_, wall, [&](const EdgeKey& e, const std::vector<Index>& at) {
    if (at.size() == 1) on_rim.insert(on_rim.end(), {e.first, e.second});
  });
  std::sort(on_rim.begin(), on_rim.end());
  for (std::size_t i = 0, j; i < corners.size(); i = j) {
    const VertexIndex v = corners[i];
    for (j = i; j < corners.size() && corners[j] == v;) ++j;
    if (!std::binary_search(on_rim.begin(), on_rim.end(), v) && (n_facets_at_[v] != j - i || is_held_[v])) return false;
  }
  return true;
}

/// Returns whether the edge has exactly two facets, and no well can run along it.
bool WallSearch::is_free_inside(VertexIndex a, VertexIndex b) const {
  if (is_held_[a] && is_held_[b]) return false;
  const auto less = [](const EdgeFacets::Use& use, const EdgeKey& edge) { return EdgeKey(use.a, use.b) < edge; };
  const auto first = std::lower_bound(edges_.uses.begin(), edges_.uses.end(), EdgeKey(a, b), less);
  std::ptrdiff_t n = 0;
  for (auto at = first; at != edges_.uses.end() && at->a == a && at->b == b; ++at) ++n;
  return n == 2;
}

}  // namespace geomesh::geomodel::arrangement
