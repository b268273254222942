// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines which parts of horizons with throw may be missing beyond their faults.
#pragma once

#include "check/mesh/checked_faces.hpp"

namespace geomesh::geomodel::checking {

/// Any place of a horizon with throw may be absent, because data may overshoot a fault into another block. But then the
/// mesh has the horizon somewhere above or below the place, or a fault passes there within the horizon's heights (the
/// heave). Otherwise a rule, a body or the volume must have removed the place, or another given place above or below
/// it. Sampled places where none of this holds are lost. If they amount to more than three hundredths of the horizon's
/// area in the volume, they are reported as `horizon_lost_beyond_faults`. `reach` is how far surfaces may be off in the
/// map. Cost: at most 256 places for a large triangle, one for a small one, each O(log n).
void check_throw_cover(const CheckedFaces& checked, double reach, CheckResult& result);

}  // namespace geomesh::geomodel::checking
