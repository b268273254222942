// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Detects units that are joined through a gap in a horizon which the project should have closed by default.
#pragma once

#include <string>
#include <vector>

#include "check/mesh/checked_faces.hpp"

namespace geomesh::geomodel::checking {

/// An entry of `open_borders` in a run's report: a horizon that ends before it reaches another surface, or has holes.
struct ReportedGap {
  std::string horizon, region;
  bool joins_units;
};

/// Reports a region that lies on both sides of a horizon of the column through a gap if the whole border of the gap has
/// another surface in front of it, closer than half of the distance over which horizons are continued
/// (`units_joined_by_gap`). The gap is found from the mesh itself: the cells of the region are divided by which side of
/// the horizon is nearer, along paths through the region that cross no face of a surface, and the faces between both
/// parts fill the gap. If part of a gap's border has nothing in front of it, the horizon has a free end there, which is
/// no error. Nor is a gap an error if the run itself reported that the horizon stops short or has a hole, or that units
/// are joined in this region; the gap is then listed among the checks done. `told` are the gaps in the report beside
/// the mesh. Precondition: a face set. O(n log n) in the cells of such regions.
void check_gaps(const CheckedFaces& checked, const std::vector<ReportedGap>& told, CheckResult& result);

}  // namespace geomesh::geomodel::checking
