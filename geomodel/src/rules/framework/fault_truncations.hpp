// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds faults that are truncated by younger unconformities.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// Returns pairs of faults and the horizons that truncate them, for BuiltRows::truncations. A fault without a rule for
/// its extent is truncated by a horizon that erodes if some of the fault's upper border in the model is within
/// ContinuationRules::within_of_faults of that horizon. If there is none, the fault is truncated by the nearest horizon
/// that has all of the upper border within that distance. A fault whose upper border lies entirely above a horizon is
/// not truncated by it: it displaces the horizon and ends a little higher. The exception is a horizon that runs through
/// most of the triangles at the upper border, which then overshoot it. O(n^2) for n border edges of a fault, and a
/// search for each of these and each horizon near it.
std::vector<std::pair<Index, Index>> fault_truncations(const std::vector<TriangulatedSurface>& surfaces,
                                                       const ModelRules& rules);

/// Returns the horizons that truncate some fault, ascending.
std::vector<Index> truncating_horizons(const std::vector<std::pair<Index, Index>>& truncations);

/// Removes from the soup the parts of faults beyond the horizons that truncate them, up to the distance `within` (m).
/// Adds the removed area to `area`, and reports it in the notes.
void truncate_faults(WorkingSoup& working, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                     double within, std::vector<double>& area, std::vector<std::string>& notes);

}  // namespace geomesh::geomodel
