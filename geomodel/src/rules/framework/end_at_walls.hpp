// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Removes from the arranged soup the continuations of surfaces beyond the bounding surface at which they end.
#pragma once

#include <span>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// Part number of the original triangles of a surface, as opposed to its continuations.
inline constexpr Index given_part = 0;

/// Returns for each triangle of a surface 0 if it is original, else the number of the run of border that it continues;
/// empty if the surface was not continued.
std::span<const Index> part_of(const BuiltRows& built, Index row);

/// Removes from the soup the parts of continuations of surface `row` that bounding surfaces (BuiltRows::continued_to)
/// separate from the surface's original triangles. A continuation is connected with original triangles only where both
/// share a corner, not where they cross: continuations from both sides of a fault cross each other beyond it. Returns
/// the area removed. O(n log m) for n facets of the surface among m of the soup, and one pass over all m.
double end_at_walls(WorkingSoup& working, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                    Index row);

}  // namespace geomesh::geomodel
