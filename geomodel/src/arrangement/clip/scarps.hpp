// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds scarps: parts of faults that separate the model from what lies beyond its topography or base.
#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/model/arranged.hpp"
#include "arrangement/model/ingest.hpp"

namespace geomesh::geomodel::arrangement {

/// Returns a mark for each facet: 1 for scarps. A topography with throw ends at a fault on both sides, higher on one
/// than on the other. The fault between these ends has ground on one side and air on the other; likewise at the bottom
/// of the model. A piece of a fault is bounded by its edges with the topography or base. It is a scarp if it lies below
/// an end of that surface on one side, and above an end on the other side. Up to a hundredth of the length of the ends
/// may contradict this. Exact predicates at rounded places decide the sides. O(n log n).
std::vector<std::uint8_t> scarps(const Arranged& arranged, const SurfaceList& surfaces);

}  // namespace geomesh::geomodel::arrangement
