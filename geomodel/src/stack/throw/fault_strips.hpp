// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Strips of the map along faults with throw, in which horizons are built from both sides.
#pragma once

#include <vector>

#include "stack/map/map_raster.hpp"
#include "stack/throw/block_data.hpp"

namespace geomesh::geomodel {

struct FaultStrips {
  MapRaster inside;                         ///< negative inside the strips
  std::vector<std::vector<Vec2>> outlines;  ///< smooth outlines of the strips, in pieces of about the size
  bool is_open = false;                     ///< whether a horizon with throw is entirely absent somewhere
  bool any() const { return !outlines.empty(); }
  bool holds(Vec2 p) const { return any() && inside.between(p) < 0; }
};

/// Finds where blocks of any of the horizons overlap in the map, or where no single block is present, and adds a
/// margin: a fraction of the size, so that on the outline each horizon has data.
FaultStrips find_fault_strips(const std::vector<BlockData>& horizons, const MapBounds& bounds, double size);

}  // namespace geomesh::geomodel
