// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Facets as thin as rounding, and facets far smaller than the tolerance, taken out of what is arranged.
#pragma once

#include "arrangement/join/join_surfaces.hpp"

namespace geomesh::geomodel::arrangement {

/// Rounding leaves facets that are some units in the last place wide, as where three surfaces nearly meet in a point.
/// No points fit between their sides, so that meshes get flat cells there. What is within the distance about them is
/// brought together: corners become one, or come to lie on the edge beside them. So is a slit (mark_slits) that a
/// needle has left. Places where a facet cannot follow stay. Where facets meet anew, all stay. Precondition: nothing
/// meets. Cost: that of snap_near, a few times, and of the contacts of what changed.
SnapOutcome flatten_slivers(Complex& complex, const Joining& joining, const RunContext& context,
                            std::size_t memory_bound);

/// The same of specks, whose sides are all shorter than the distance, and of facets thinner than it that have a corner
/// of one. Where surfaces lie in each other within a tolerance, they cross in swarms far smaller than it, of a hundred
/// vertices and more.
SnapOutcome merge_specks(Complex& complex, const Joining& joining, const RunContext& context, std::size_t memory_bound);

}  // namespace geomesh::geomodel::arrangement
