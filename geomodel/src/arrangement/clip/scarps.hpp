// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds scarps: parts of faults that separate the model from what lies beyond its topography or base.
#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/model/arranged.hpp"
#include "arrangement/model/ingest.hpp"

namespace geomesh::geomodel::arrangement {

/// Returns 1 for each facet of a scarp, else 0. A fault with throw cuts the topography, which ends at different heights
/// on its two sides. The fault between these two ends is a scarp: it has ground on one side and air on the other. The
/// same holds for the base of the model. Edges with the topography or base divide a fault into pieces. A piece is a
/// scarp if it is below an end of that surface on one side, and above an end on the other. Up to a hundredth of the
/// length of the ends may contradict this. Exact predicates at rounded places decide the sides. O(n log n).
std::vector<std::uint8_t> scarps(const Arranged& arranged, const SurfaceList& surfaces);

}  // namespace geomesh::geomodel::arrangement
