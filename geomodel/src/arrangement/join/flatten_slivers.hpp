// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Removes facets that are thin within rounding, and facets far smaller than the tolerance.
#pragma once

#include "arrangement/join/join_surfaces.hpp"

namespace geomesh::geomodel::arrangement {

/// Rounding leaves facets that are a few ulps wide, as where three surfaces nearly meet in a point. No mesh points fit
/// between their sides, so the mesh gets flat cells there. Everything within the distance of such facets is merged:
/// corners are snapped together or moved to the edge beside them. Cracks (mark_cracks) that a needle has left are
/// closed in the same way. A place where a facet cannot be moved is left unchanged; if facets would cross anew, all
/// places are. Precondition: no facets cross. Cost: that of snap_near(), a few times, and of finding the contacts of
/// the changed facets.
SnapOutcome flatten_slivers(Complex& complex, const Joining& joining, const RunContext& context,
                            std::size_t memory_bound);

/// Merges tiny features (facets whose sides are all shorter than the merging distance), and facets at their corners
/// that are thinner than this distance. Surfaces that nearly coincide within a tolerance cross in swarms of tiny
/// features, with a hundred vertices or more.
SnapOutcome merge_specks(Complex& complex, const Joining& joining, const RunContext& context, std::size_t memory_bound);

}  // namespace geomesh::geomodel::arrangement
