// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What horizons with throw may lack beyond their faults.
#pragma once

#include "check/judged/claimed_faces.hpp"

namespace geomesh::geomodel::checking {

/// Any place of a horizon with throw may be away: it is given beyond a fault, and the block there is another one. But
/// over or under it the mesh has the horizon somewhere, or a fault passes there within the horizon's heights (the
/// heave). Otherwise a rule, a body or the volume must take the place, or another given place over or under it.
///
/// Places sampled where none of this is so are lost. Where they are more than three hundredths of the horizon's area in
/// the volume, they are the fault `horizon_lost_beyond_faults`. `reach`: in the map, how far off surfaces may be.
/// Cost: at most 256 places for a large triangle, one for a small one, each O(log n).
void check_throw_cover(const ClaimedFaces& claimed, double reach, CheckResult& result);

}  // namespace geomesh::geomodel::checking
