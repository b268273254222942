// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Strips of the map along faults with throw, in which horizons come from both sides.
#pragma once

#include <vector>

#include "stack/map/map_raster.hpp"
#include "stack/throw/block_data.hpp"

namespace geomesh::geomodel {

struct FaultStrips {
  MapRaster inside;                         ///< negative in the strips
  std::vector<std::vector<Vec2>> outlines;  ///< smooth, in pieces of about the size
  bool is_open = false;                     ///< a horizon with throw is somewhere not there at all
  bool any() const { return !outlines.empty(); }
  bool holds(Vec2 p) const { return any() && inside.between(p) < 0; }
};

/// Where blocks of any of the horizons lie over each other, or none alone is there, and a margin about it: a fraction
/// of the size, so that the outline lies where each horizon has data.
FaultStrips find_fault_strips(const std::vector<BlockData>& horizons, const MapBounds& bounds, double size);

}  // namespace geomesh::geomodel
