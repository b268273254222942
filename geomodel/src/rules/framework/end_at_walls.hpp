// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Continuations in the arranged soup: what lies beyond the wall is removed.
#pragma once

#include <span>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// Part of the triangles that no continuation made.
inline constexpr Index given_part = 0;

/// BuiltRows::part_of_triangle of a surface; empty where nothing continued it.
std::span<const Index> part_of(const BuiltRows& built, Index row);

/// Removes from the soup the parts of continuations of surface `row` that the walls at which they end
/// (BuiltRows::continued_to) cut off from what was given. A continuation hangs together with what was given where both
/// share a corner of the surface, and with nothing else that it crosses: continuations from both sides of a fault cross
/// each other beyond it. Gives the area removed. O(n log m) for n facets of the surface among m of the soup, and one
/// pass over these.
double end_at_walls(WorkingSoup& working, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                    Index row);

}  // namespace geomesh::geomodel
