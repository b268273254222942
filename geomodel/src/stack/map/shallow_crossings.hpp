// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Detects horizons that cross at so small an angle that no well-shaped element fits between them.
#pragma once

#include "stack/map/map_samples.hpp"

namespace geomesh::geomodel {

/// Returns whether some horizon crosses a younger one at less than 2 degrees. The heights are compared on a lattice
/// with an eighth of the target size as spacing, or on one of 250,000 places if that is coarser. Places where both are
/// within 1e-5 of the size of each other are ignored, because the horizons coincide there. O(places * horizons).
bool cross_at_small_angle(const MapSamples& samples, const MapBounds& bounds, double size);

}  // namespace geomesh::geomodel
