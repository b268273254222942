// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizons at which faults end: unconformities, younger than the faults below them.
#pragma once

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// Pairs of faults and horizons, as BuiltRows::roofs has them. A fault without an extent of its own ends at a horizon
/// that erodes where some of its upper border in the model is within ContinuationRules::within_of_faults of it. Without
/// such a horizon, it ends at the nearest one of which all of it is within that distance, and not all above.
/// O(n^2) for n border vertices of a fault, and a search for each of these and each horizon near it.
std::vector<std::pair<Index, Index>> fault_roofs(const std::vector<TriangulatedSurface>& surfaces,
                                                 const ModelRules& rules);

/// The horizons among these, ascending.
std::vector<Index> horizons_of(const std::vector<std::pair<Index, Index>>& roofs);

/// Takes off the soup what faults have beyond their roofs, up to `within` (m). Returns the area by surface.
void end_at_roofs(WorkingSoup& working, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                  double within, std::vector<double>& area, std::vector<std::string>& notes);

}  // namespace geomesh::geomodel
