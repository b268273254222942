// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Units that are joined through a gap which the project has closed by default.
#pragma once

#include <string>
#include <vector>

#include "check/judged/claimed_faces.hpp"

namespace geomesh::geomodel::checking {

/// An entry of `open_borders` in the report of a run: a horizon stops short or has holes.
struct ToldGap {
  std::string horizon, region;
  bool joins_units;
};

/// A region that lies on both sides of a horizon of the column through a gap that has something else before all of its
/// border, nearer than half of the distance over which horizons are continued (`units_joined_by_gap`). The mesh itself
/// tells the gap: the cells of the region are divided by which side of the horizon is nearer, along ways through the
/// region that cross no face of a surface, and the faces between both kinds fill it. A gap with nothing before some of
/// its border is an end in the open, which is no fault.
///
/// Such a gap is no fault where the run itself told that the horizon stops short or has a hole, or that units join in
/// this region: it is told among what was checked. `told`: of the report beside the mesh.
///
/// Shared with the mesher: the distance, which the documents promise. Precondition: a face set. O(n log n) in the cells
/// of such regions.
void check_gaps(const ClaimedFaces& claimed, const std::vector<ToldGap>& told, CheckResult& result);

}  // namespace geomesh::geomodel::checking
