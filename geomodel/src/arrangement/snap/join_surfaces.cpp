// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/snap/join_surfaces.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace geomesh::geomodel::arrangement {

std::optional<SnapOutcome> join_what_lies_in_each_other(Complex& complex, const Contacts& contacts,
                                                        const Joining& joining) {
  std::set<SurfacePair> pairs = surfaces_in_contact(complex, contacts);
  std::erase_if(pairs, [&](const SurfacePair& pair) { return pair.second >= joining.first_side; });
  if (pairs.empty()) return std::nullopt;
  // Needles that this makes in a surface or a side go, too.
  for (const auto& [a, b] : std::set(pairs)) pairs.insert({{a, a}, {b, b}});
  for (const Origin& o : complex.origins.items)
    if (o.surface >= joining.first_side) pairs.insert({o.surface, o.surface});
  const JoinRule rule =
      JoinRule::all_of(std::move(pairs), joining.sides_are_fixed ? static_cast<Index>(joining.first_side) : no_index);
  Complex joined = complex;
  SnapOutcome outcome = snap_near(joined, std::vector<std::uint8_t>(joined.facets.size(), 1),
                                  {joining.distance, joining.box, MoveToBox::none, rule});
  if (!outcome.changed() || !outcome.facets_left_alone.empty()) return std::nullopt;
  complex = std::move(joined);
  return outcome;
}

}  // namespace geomesh::geomodel::arrangement
