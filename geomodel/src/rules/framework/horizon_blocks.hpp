// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The fault blocks that horizons are divided by, with their walls.
#pragma once

#include "rules/framework/block_framework.hpp"
#include "rules/framework/walls.hpp"

namespace geomesh::geomodel {

struct HorizonBlocks {
  BlockFramework framework;
  Walls cutters;                   ///< faults as they end on each other, and bodies
  Walls walls;                     ///< horizons and the sides of the model, too
  std::vector<Index> fill_blocks;  ///< horizons that fill each block in which they have data
};

}  // namespace geomesh::geomodel
