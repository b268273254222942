// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Measures how far surfaces receded because facets vanished.
#pragma once

#include <span>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// Returns the largest distance of places on vanished facets from what is left of their surfaces. A facet that vanishes
/// inside a surface leaves its neighbours there. A facet between the end of a surface and another surface may have been
/// narrow and long, so that its surface then ends earlier. `distance` is the merging distance. Sampled places are no
/// closer to each other than it, or 1/256 of their edge. Results below a thousandth of it count as zero. If nothing is
/// left of a surface, the result is the extent of its vanished facets. O(n log n) for the surfaces that lost facets.
Displacement lost_with(std::span<const VanishedFacet> vanished, const Complex& complex, double distance);

}  // namespace geomesh::geomodel::arrangement
