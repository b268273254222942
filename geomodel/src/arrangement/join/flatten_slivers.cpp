// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/join/flatten_slivers.hpp"

#include <algorithm>
#include <set>

#include "arrangement/snap/cracks.hpp"
#include "common/union_find.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

constexpr unsigned most_rounds = 4;  // facets that one round leaves unchanged may allow others to move in the next

double longest_side(const Complex& complex, const Triangle& t) {
  const Vec3 &a = complex.points[t[0]], &b = complex.points[t[1]], &c = complex.points[t[2]];
  return std::max({length(b - a), length(c - b), length(a - c)});
}

bool is_sliver(const Complex& complex, const Triangle& t, double width) {
  return 2 * area(complex.points[t[0]], complex.points[t[1]], complex.points[t[2]]) < width * longest_side(complex, t);
}

/// Active facets connected at vertices with facets of `left_alone` are not moved either.
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

/// Merges everything within the distance of active facets. If facets would meet anew, or one cannot be moved, nothing
/// is done.
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

}  // namespace geomesh::geomodel::arrangement
