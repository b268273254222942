// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Measures what surfaces lost with facets that vanished.
#pragma once

#include <span>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// Returns the largest distance of places on vanished facets from what is left of their surfaces. A facet that vanishes
/// inside a surface leaves its neighbours there. One between an end of the surface and another surface may have been
/// narrow and long, so that its surface ends earlier. `distance` is that of merging. Sampled places are no nearer to
/// each other than it, or a 256th of their edge. Less than a thousandth of it counts as zero. If nothing is left of a
/// surface, the result is the extent of what vanished. O(n log n) for the surfaces of which anything vanished.
Displacement lost_with(std::span<const VanishedFacet> vanished, const Complex& complex, double distance);

}  // namespace geomesh::geomodel::arrangement
