// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Removes facets that are thin within rounding.
#pragma once

#include "arrangement/join/join_surfaces.hpp"

namespace geomesh::geomodel::arrangement {

/// Rounding leaves facets that are a few ulps wide, as where three surfaces nearly meet in a point. No mesh points fit
/// between their sides, so the mesh gets flat cells there. Everything within the distance of such facets is merged:
/// corners are snapped together or moved to the edge beside them. Cracks (mark_cracks) that a needle has left are
/// closed in the same way. If facets would cross anew, the complex is left unchanged. Precondition: no facets cross.
/// Cost: that of snap_near(), and of finding the contacts of the changed facets.
SnapOutcome flatten_slivers(Complex& complex, const Joining& joining, const RunContext& context,
                            std::size_t memory_bound);

}  // namespace geomesh::geomodel::arrangement
