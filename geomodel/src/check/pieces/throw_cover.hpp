// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines which parts of horizons with throw may be missing beyond their faults.
#pragma once

#include "check/mesh/checked_faces.hpp"

namespace geomesh::geomodel::checking {

/// Checks that horizons with throw are missing only beyond their faults. Any point of such a horizon may be missing in
/// the mesh, because data may overshoot a fault into another block. But then the mesh has the horizon somewhere above
/// or below the point, or a fault passes above or below it within the horizon's heights (the heave), or a rule, a body
/// or the volume removed the horizon at the point or above or below it. Sampled points where none of this holds are
/// lost. If they amount to more than three hundredths of the horizon's area in the volume, they are reported as
/// `horizon_lost_beyond_faults`. `reach` is the largest horizontal displacement of surfaces. Cost: at most 256 sampled
/// points for a large triangle, one for a small one, each O(log n).
void check_throw_cover(const CheckedFaces& checked, double reach, CheckResult& result);

}  // namespace geomesh::geomodel::checking
