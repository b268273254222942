// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Inserts vertices into the facets and segments of a complex.
#pragma once

#include <set>
#include <vector>

#include "arrangement/model/displacement.hpp"
#include "arrangement/snap/snap.hpp"

namespace geomesh::geomodel::arrangement {

/// Splits facets and segments at the vertices inserted in them and in their edges. A piece of `edges` (sorted) becomes
/// an edge of each facet that has both its vertices. If a facet cannot be split, its edges are not divided, and their
/// insertions are removed from `insertions`. `touched` are facets of which a corner was replaced. Facets without area
/// are removed, equal ones merged. Adds counts to `outcome`, and distances of edges from the vertices inserted in them
/// to `moves`. O(n log n) in the number of edges and facets.
void rebuild_with(Complex& complex, Insertions& insertions, const std::vector<EdgeKey>& edges,
                  const std::set<Index>& touched, SnapOutcome& outcome, MovesOfStep& moves);

}  // namespace geomesh::geomodel::arrangement
