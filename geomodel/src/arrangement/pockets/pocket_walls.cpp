// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/pockets/pocket_walls.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "common/union_find.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

constexpr double least_part = 0.3, most_part = 0.7;  // of the area of a pocket: what one of its two walls takes

using Edge = std::pair<VertexIndex, VertexIndex>;

std::map<Edge, std::vector<Index>> facets_by_edge(const Complex& complex, const std::vector<FacetSide>& sides) {
  std::map<Edge, std::vector<Index>> at;
  for (const FacetSide s : sides) {
    const Triangle& t = complex.facets[facet_of(s)];
    for (std::size_t k = 0; k < 3; ++k) at[std::minmax(t[k], t[(k + 1) % 3])].push_back(facet_of(s));
  }
  return at;
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

std::vector<Index> surfaces_of_facet(const Complex& complex, Index facet) {
  std::vector<Index> surfaces;
  for (const Origin& o : complex.origins.of(facet)) surfaces.push_back(o.surface);
  std::sort(surfaces.begin(), surfaces.end());
  surfaces.erase(std::unique(surfaces.begin(), surfaces.end()), surfaces.end());
  return surfaces;
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
  const auto is_of_volume = [&](FacetSide s) { return surfaces_of_facet(complex_, facet_of(s)).back() >= first_side_; };
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

/// Facets of one list of surfaces, joined across edges on which nothing else hangs.
std::vector<std::vector<FacetSide>> WallSearch::parts_of(const std::vector<FacetSide>& shell) const {
  std::map<Index, Index> row;  // in the shell
  for (std::size_t k = 0; k < shell.size(); ++k) row[facet_of(shell[k])] = static_cast<Index>(k);
  UnionFind joined(shell.size());
  for (const auto& [edge, at] : facets_by_edge(complex_, shell))
    if (at.size() == 2 && is_free_inside(edge.first, edge.second) &&
        surfaces_of_facet(complex_, at[0]) == surfaces_of_facet(complex_, at[1]))
      joined.unite(row[at[0]], row[at[1]]);
  std::map<Index, std::vector<FacetSide>> parts;
  for (std::size_t k = 0; k < shell.size(); ++k) parts[joined.find(static_cast<Index>(k))].push_back(shell[k]);
  std::vector<std::vector<FacetSide>> all;
  for (auto& [root, part] : parts) all.push_back(std::move(part));
  return all;
}

/// The vertices inside it are its own.
bool WallSearch::can_go(const std::vector<FacetSide>& wall) const {
  std::map<VertexIndex, Index> n_at;
  for (const FacetSide s : wall)
    for (const VertexIndex v : complex_.facets[facet_of(s)]) ++n_at[v];
  std::set<VertexIndex> on_rim;
  for (const auto& [edge, at] : facets_by_edge(complex_, wall))
    if (at.size() == 1) on_rim.insert({edge.first, edge.second});
  return std::all_of(n_at.begin(), n_at.end(), [&](const auto& at) {
    return on_rim.contains(at.first) || (n_facets_at_[at.first] == at.second && !is_held_[at.first]);
  });
}

/// Two facets share the edge, and no well can run along it.
bool WallSearch::is_free_inside(VertexIndex a, VertexIndex b) const {
  if (is_held_[a] && is_held_[b]) return false;
  const auto less = [](const EdgeFacets::Use& use, const Edge& edge) { return Edge(use.a, use.b) < edge; };
  const auto first = std::lower_bound(edges_.uses.begin(), edges_.uses.end(), Edge(a, b), less);
  std::ptrdiff_t n = 0;
  for (auto at = first; at != edges_.uses.end() && at->a == a && at->b == b; ++at) ++n;
  return n == 2;
}

}  // namespace geomesh::geomodel::arrangement
