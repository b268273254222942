// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The fault blocks in which horizons are continued, with their bounding surfaces.
#pragma once

#include "rules/framework/block_framework.hpp"
#include "rules/framework/walls.hpp"

namespace geomesh::geomodel {

struct HorizonBlocks {
  BlockFramework framework;
  Walls cutters;  ///< bodies, and faults cut where they end on each other
  Walls walls;    ///< surfaces at which continuations of horizons end: faults, bodies, horizons, model's sides
  std::vector<Index> fill_blocks;  ///< indices of horizons continued through each block in which they have data
};

}  // namespace geomesh::geomodel
