// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Removes facets as thin as rounding.
#pragma once

#include "arrangement/join/join_surfaces.hpp"

namespace geomesh::geomodel::arrangement {

/// Rounding leaves facets that are some units in the last place wide, as where three surfaces nearly meet in a point.
/// No points fit between their sides, so meshes get flat cells there. Everything within the distance of such facets is
/// merged: corners become one, or come to lie on the edge beside them. The same applies to a crack (mark_cracks) that a
/// needle has left. If facets would meet anew, nothing is changed. Precondition: nothing meets. Cost: that of
/// snap_near, and of the contacts of the changed facets.
SnapOutcome flatten_slivers(Complex& complex, const Joining& joining, const RunContext& context,
                            std::size_t memory_bound);

}  // namespace geomesh::geomodel::arrangement
