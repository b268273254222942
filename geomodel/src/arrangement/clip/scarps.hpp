// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds scarps: parts of faults that separate the model from what lies beyond its topography or base.
#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/model/arranged.hpp"
#include "arrangement/model/ingest.hpp"

namespace geomesh::geomodel::arrangement {

/// Marks facets of scarps with 1, by facet. A topography with throw ends at a fault on both sides, higher on one than
/// on the other. The fault between these ends has ground on one side and air on the other; likewise at the bottom of
/// the model. A piece of a fault is connected between edges with that surface. It is a scarp if it lies below an end of
/// the surface on its one side, and above one on its other side. Up to a hundredth of the length of the ends may
/// contradict this. Sides are decided by exact predicates at rounded places. O(n log n).
std::vector<std::uint8_t> scarps(const Arranged& arranged, const SurfaceList& surfaces);

}  // namespace geomesh::geomodel::arrangement
