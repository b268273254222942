// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/join/flatten_slivers.hpp"

#include <algorithm>
#include <set>

#include "arrangement/snap/cracks.hpp"
#include "common/union_find.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

// Number of attempts to move facets; where a facet could not be moved, the next attempt moves nothing.
constexpr unsigned most_rounds = 4;

double longest_side(const Complex& complex, const Triangle& t) {
  const Vec3 &a = complex.points[t[0]], &b = complex.points[t[1]], &c = complex.points[t[2]];
  return std::max({length(b - a), length(c - b), length(a - c)});
}

bool is_sliver(const Complex& complex, const Triangle& t, double width) {
  return 2 * area(complex.points[t[0]], complex.points[t[1]], complex.points[t[2]]) < width * longest_side(complex, t);
}

/// Unmarks in `active` facets that marked ones connect, through shared vertices, with a facet that could not move.
void leave_places_of(const std::vector<Index>& left_alone, const Complex& complex, std::vector<std::uint8_t>& active) {
  UnionFind joined(complex.points.size());
  const auto join_corners = [&](Index f) {
    for (const VertexIndex v : complex.facets[f]) joined.unite(complex.facets[f][0], v);
  };
  for (Index f = 0; f < active.size(); ++f)
    if (active[f]) join_corners(f);
  std::for_each(left_alone.begin(), left_alone.end(), join_corners);
  std::set<Index> roots;
  for (const Index f : left_alone) roots.insert(joined.find(complex.facets[f][0]));
  for (Index f = 0; f < active.size(); ++f)
    if (active[f] && roots.contains(joined.find(complex.facets[f][0]))) active[f] = 0;
}

/// Merges all that is within the merging distance of marked, movable facets; nothing if facets would cross anew.
SnapOutcome bring_together(Complex& complex, std::vector<std::uint8_t> active, const Joining& joining,
                           const RunContext& context, std::size_t memory_bound) {
  const JoinRule rule =
      joining.sides_are_fixed ? JoinRule::all_but(static_cast<Index>(joining.first_side)) : JoinRule();
  const SnapOptions options{joining.distance, joining.box, MoveToBox::none, rule};
  for (unsigned round = 0; round < most_rounds && std::ranges::count(active, 1) > 0; ++round) {
    Complex flattened = complex;
    const SnapOutcome outcome = snap_near(flattened, active, options);
    if (!outcome.facets_left_alone.empty()) {
      leave_places_of(outcome.facets_left_alone, complex, active);
      continue;
    }
    if (!find_contacts(flattened, context, memory_bound).empty()) return {};
    complex = std::move(flattened);
    return outcome;
  }
  return {};
}

}  // namespace

SnapOutcome flatten_slivers(Complex& complex, const Joining& joining, const RunContext& context,
                            std::size_t memory_bound) {
  std::vector<std::uint8_t> active;
  for (const Triangle& t : complex.facets) active.push_back(is_sliver(complex, t, joining.distance));
  mark_cracks(complex, joining.distance, active);
  return bring_together(complex, std::move(active), joining, context, memory_bound);
}

SnapOutcome merge_specks(Complex& complex, const Joining& joining, const RunContext& context,
                         std::size_t memory_bound) {
  std::vector<std::uint8_t> is_of_speck(complex.points.size(), 0), active;
  for (const Triangle& t : complex.facets)
    if (longest_side(complex, t) < joining.distance)
      for (const VertexIndex v : t) is_of_speck[v] = 1;
  for (const Triangle& t : complex.facets) {
    const bool has_speck = std::ranges::any_of(t, [&](VertexIndex v) { return is_of_speck[v] != 0; });
    active.push_back(has_speck && is_sliver(complex, t, joining.distance));
  }
  return bring_together(complex, std::move(active), joining, context, memory_bound);
}

}  // namespace geomesh::geomodel::arrangement
