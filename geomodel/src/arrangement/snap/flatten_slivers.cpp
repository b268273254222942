// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/snap/flatten_slivers.hpp"

#include <algorithm>
#include <map>

#include "arrangement/snap/slits.hpp"
#include "common/union_find.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

bool is_sliver(const Complex& complex, const Triangle& t, double width) {
  const Vec3 &a = complex.points[t[0]], &b = complex.points[t[1]], &c = complex.points[t[2]];
  const double longest = std::max({length(b - a), length(c - b), length(a - c)});
  return 2 * area(a, b, c) < width * longest;
}

/// Active facets that hang together at vertices, each set by itself.
std::vector<std::vector<Index>> places_of(const Complex& complex, const std::vector<std::uint8_t>& active) {
  UnionFind joined(complex.points.size());
  for (Index f = 0; f < active.size(); ++f)
    if (active[f])
      for (const VertexIndex v : complex.facets[f]) joined.unite(complex.facets[f][0], v);
  std::map<Index, std::vector<Index>> places;
  for (Index f = 0; f < active.size(); ++f)
    if (active[f]) places[joined.find(complex.facets[f][0])].push_back(f);
  std::vector<std::vector<Index>> all;
  for (auto& [root, facets] : places) all.push_back(std::move(facets));
  return all;
}

/// Facets of places at which some facet cannot follow are let alone, found by trying each place by itself.
void leave_what_cannot_follow(const Complex& complex, const SnapOptions& options, std::vector<std::uint8_t>& active) {
  for (const std::vector<Index>& place : places_of(complex, active)) {
    std::vector<std::uint8_t> there(active.size(), 0);
    for (const Index f : place) there[f] = 1;
    Complex tried = complex;
    if (snap_near(tried, there, options).n_facets_left_alone == 0) continue;
    for (const Index f : place) active[f] = 0;
  }
}

}  // namespace

SnapOutcome flatten_slivers(Complex& complex, const Joining& joining, const RunContext& context,
                            std::size_t memory_bound) {
  std::vector<std::uint8_t> active;
  for (const Triangle& t : complex.facets) active.push_back(is_sliver(complex, t, joining.distance));
  mark_slits(complex, joining.distance, active);
  const JoinRule rule =
      joining.sides_are_fixed ? JoinRule::all_but(static_cast<Index>(joining.first_side)) : JoinRule();
  const SnapOptions options{joining.distance, joining.box, MoveToBox::none, rule};
  for (const bool all : {true, false}) {
    if (!all) leave_what_cannot_follow(complex, options, active);
    if (std::ranges::count(active, 0) == std::ssize(active)) return {};
    Complex flattened = complex;
    const SnapOutcome outcome = snap_near(flattened, active, options);
    if (outcome.n_facets_left_alone > 0) continue;
    if (!find_contacts(flattened, context, memory_bound).empty()) return {};
    complex = std::move(flattened);
    return outcome;
  }
  return {};
}

}  // namespace geomesh::geomodel::arrangement
