// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The fault blocks that divide horizons, with their walls.
#pragma once

#include "rules/framework/block_framework.hpp"
#include "rules/framework/walls.hpp"

namespace geomesh::geomodel {

struct HorizonBlocks {
  BlockFramework framework;
  Walls cutters;                   ///< faults, cut where they end on each other, and bodies
  Walls walls;                     ///< the same, with horizons and the sides of the model
  std::vector<Index> fill_blocks;  ///< rows of the horizons that fill each block in which they have data
};

}  // namespace geomesh::geomodel
