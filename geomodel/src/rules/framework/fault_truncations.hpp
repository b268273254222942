// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds faults that are truncated by unconformities younger than they are.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// Returns pairs of faults and the horizons that truncate them, as BuiltRows::truncations has them. A fault without an
/// extent of its own is truncated by a horizon that erodes if some of the fault's upper border in the model is within
/// ContinuationRules::within_of_faults of it. If there is none, it is truncated by the nearest horizon that has all of
/// the upper border within that distance. An upper border entirely above the horizon belongs to a fault that displaces
/// the horizon and ends a little higher, unless the horizon runs through most of the triangles at the border: then
/// these overshoot. O(n^2) for n border edges of a fault, and a search for each of these and each horizon near it.
std::vector<std::pair<Index, Index>> fault_truncations(const std::vector<TriangulatedSurface>& surfaces,
                                                       const ModelRules& rules);

/// Returns the horizons in these pairs, ascending.
std::vector<Index> truncating_horizons(const std::vector<std::pair<Index, Index>>& truncations);

/// Removes from the soup the parts of faults beyond the horizons that truncate them, up to `within` (m). Adds the area
/// to that of the surface, and reports it in the notes.
void truncate_faults(WorkingSoup& working, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                     double within, std::vector<double>& area, std::vector<std::string>& notes);

}  // namespace geomesh::geomodel
