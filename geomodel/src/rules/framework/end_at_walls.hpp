// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Removes continuations in the arranged soup beyond the wall at which they end.
#pragma once

#include <span>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// Part number of the triangles that no continuation made.
enum PartNumber : Index { given_part };

/// Returns BuiltRows::part_of_triangle of a surface; empty if it was not continued.
std::span<const Index> part_of(const BuiltRows& built, Index row);

/// Removes from the soup the parts of continuations of surface `row` that the walls at which they end
/// (BuiltRows::continued_to) separate from the given triangles. A continuation is connected with given triangles only
/// where both share a corner of the surface, not where they cross: continuations from both sides of a fault cross each
/// other beyond it. Returns the area removed. O(n log m) for n facets of the surface among m of the soup, and one pass
/// over these.
double end_at_walls(WorkingSoup& working, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                    Index row);

}  // namespace geomesh::geomodel
