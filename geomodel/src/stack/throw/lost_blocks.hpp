// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Whether triangles of the size hold the blocks of a horizon with throw.
#pragma once

#include "stack/map/map_frame.hpp"
#include "stack/map/map_samples.hpp"
#include "stack/throw/block_data.hpp"
#include "stack/throw/both_sides.hpp"

namespace geomesh::geomodel {

/// The faults of the horizon, in the model, and where the map's frame is.
struct BlockPlaces {
  const HorizonFaults& faults;
  const MapFrame& frame;
  const MapBounds& bounds;
};

/// Looks where one block alone was given. The block must be there still, and have triangles that cross no fault. True
/// where that is not so for more than a fiftieth of the places. Places are on a grid over the bounds, 48 each way. True
/// as well where a block has no such triangles, and at any place lies on its own side of all faults.
bool loses_blocks(const BlockData& before, const SidedHorizon& after, const BlockPlaces& places);

}  // namespace geomesh::geomodel
