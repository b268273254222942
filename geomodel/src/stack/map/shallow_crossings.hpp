// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Whether horizons cross at so small an angle that no element of a good shape fits between them.
#pragma once

#include "stack/map/map_samples.hpp"

namespace geomesh::geomodel {

/// Whether some horizon crosses those before it (the younger ones, of which it can be over none) at less than 2
/// degrees. That is asked on a lattice of an eighth of the size, or of 250,000 places where those are fewer. Places
/// where both are within 1e-5 of the size do not count: there they share a surface. O(places * horizons).
bool cross_at_small_angle(const MapSamples& samples, const MapBounds& bounds, double size);

}  // namespace geomesh::geomodel
