// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds strips of the map along faults with throw, in which horizons are built from both sides.
#pragma once

#include <vector>

#include "stack/map/map_raster.hpp"
#include "stack/throw/block_data.hpp"

namespace geomesh::geomodel {

struct FaultStrips {
  MapRaster inside;                         ///< raster of the map, negative inside the strips along faults
  std::vector<std::vector<Vec2>> outlines;  ///< smooth outlines of the strips, in pieces of about the target size
  bool is_open = false;                     ///< whether a horizon with throw is entirely absent at some place
  bool any() const { return !outlines.empty(); }
  bool holds(Vec2 p) const { return any() && inside.between(p) < 0; }
};

/// Finds the strips along faults: places of the map where blocks of a horizon overlap or none is present, with a
/// margin. The margin is a fraction of the target size, so that on the outline each horizon has data.
FaultStrips find_fault_strips(const std::vector<BlockData>& horizons, const MapBounds& bounds, double size);

}  // namespace geomesh::geomodel
