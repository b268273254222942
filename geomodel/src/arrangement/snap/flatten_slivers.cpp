// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/snap/flatten_slivers.hpp"

#include <algorithm>

namespace geomesh::geomodel::arrangement {

namespace {

bool is_sliver(const Complex& complex, const Triangle& t, double width) {
  const Vec3 &a = complex.points[t[0]], &b = complex.points[t[1]], &c = complex.points[t[2]];
  const double longest = std::max({length(b - a), length(c - b), length(a - c)});
  return 2 * area(a, b, c) < width * longest;
}

}  // namespace

SnapOutcome flatten_slivers(Complex& complex, const Joining& joining, const RunContext& context,
                            std::size_t memory_bound) {
  std::vector<std::uint8_t> active;
  for (const Triangle& t : complex.facets) active.push_back(is_sliver(complex, t, joining.distance));
  if (std::ranges::count(active, 0) == std::ssize(active)) return {};
  const JoinRule rule =
      joining.sides_are_fixed ? JoinRule::all_but(static_cast<Index>(joining.first_side)) : JoinRule();
  Complex flattened = complex;
  const SnapOutcome outcome = snap_near(flattened, active, {joining.distance, joining.box, MoveToBox::none, rule});
  if (outcome.n_facets_left_alone > 0 || !find_contacts(flattened, context, memory_bound).empty()) return {};
  complex = std::move(flattened);
  return outcome;
}

}  // namespace geomesh::geomodel::arrangement
