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

/// Whose a place is, in the terms of BuiltRows::block_of_triangle: the block that holds it or, with BuiltRows::
/// field_of_block, the field that holds in that block. no_index outside of the model and where no field holds.
/// Cost: of BlockFramework::block_at.
inline Index owner_at(const BlockFramework& framework, const std::vector<Index>& field_of_block, const Vec3& p) {
  const Index block = framework.block_at(p);
  return field_of_block.empty() || block == no_index ? block : field_of_block[block];
}

}  // namespace geomesh::geomodel
