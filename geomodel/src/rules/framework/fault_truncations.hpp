// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Faults that are truncated by unconformities, which are younger than they are.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// Pairs of faults and the horizons that truncate them, as BuiltRows::truncations has them. A fault without an extent
/// of its own is truncated by a horizon that erodes if some of the fault's upper border in the model is within
/// ContinuationRules::within_of_faults of it. Without such a horizon, the nearest one truncates it from which all of
/// the upper border is within that distance. A border that is all above belongs to a fault that displaces the horizon
/// and ends a little higher, unless the horizon runs through most of the triangles at the border: then these overshoot.
/// O(n^2) for n border edges of a fault, and a search for each of these and each horizon near it.
std::vector<std::pair<Index, Index>> fault_truncations(const std::vector<TriangulatedSurface>& surfaces,
                                                       const ModelRules& rules);

/// The horizons among these, ascending.
std::vector<Index> truncating_horizons(const std::vector<std::pair<Index, Index>>& truncations);

/// Takes off the soup what faults have beyond the horizons that truncate them, up to `within` (m). Adds the area to
/// that of the surface, and tells it in the notes.
void truncate_faults(WorkingSoup& working, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                     double within, std::vector<double>& area, std::vector<std::string>& notes);

}  // namespace geomesh::geomodel
