// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/join/flatten_slivers.hpp"

#include <algorithm>

#include "arrangement/snap/cracks.hpp"

namespace geomesh::geomodel::arrangement {

namespace {

double longest_side(const Complex& complex, const Triangle& t) {
  const Vec3 &a = complex.points[t[0]], &b = complex.points[t[1]], &c = complex.points[t[2]];
  return std::max({length(b - a), length(c - b), length(a - c)});
}

bool is_sliver(const Complex& complex, const Triangle& t, double width) {
  return 2 * area(complex.points[t[0]], complex.points[t[1]], complex.points[t[2]]) < width * longest_side(complex, t);
}

}  // namespace

SnapOutcome flatten_slivers(Complex& complex, const Joining& joining, const RunContext& context,
                            std::size_t memory_bound) {
  std::vector<std::uint8_t> active;
  for (const Triangle& t : complex.facets) active.push_back(is_sliver(complex, t, joining.distance));
  mark_cracks(complex, joining.distance, active);
  if (std::ranges::count(active, 1) == 0) return {};
  const JoinRule rule =
      joining.sides_are_fixed ? JoinRule::all_but(static_cast<Index>(joining.first_side)) : JoinRule();
  Complex flattened = complex;
  const SnapOutcome outcome = snap_near(flattened, active, {joining.distance, joining.box, MoveToBox::none, rule});
  if (!find_contacts(flattened, context, memory_bound).empty()) return {};
  complex = std::move(flattened);
  return outcome;
}

}  // namespace geomesh::geomodel::arrangement
