// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Checks whether triangles of the target size can represent the blocks of a horizon with throw.
#pragma once

#include "stack/map/map_frame.hpp"
#include "stack/map/map_samples.hpp"
#include "stack/throw/block_data.hpp"
#include "stack/throw/both_sides.hpp"

namespace geomesh::geomodel {

/// The faults of the horizon, in model coordinates, and the frame of the map.
struct BlockPlaces {
  const HorizonFaults& faults;
  const MapFrame& frame;
  const MapBounds& bounds;
};

/// Returns whether triangles of the target size lose blocks of a horizon. At places where only one block was present,
/// that block must still be present and have triangles that cross no fault. The result is true if that fails at more
/// than a fiftieth of the places, which lie on a grid of 48 by 48 over the bounds, or if a block has no such triangles
/// although it lies on its own side of all faults at some place.
bool loses_blocks(const BlockData& before, const SidedHorizon& after, const BlockPlaces& places);

}  // namespace geomesh::geomodel
