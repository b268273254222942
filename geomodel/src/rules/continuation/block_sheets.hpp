// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Continues a horizon block by block: in each fault block, from the given parts of the horizon there.
#pragma once

#include <vector>

#include "rules/continuation/border_chains.hpp"
#include "rules/continuation/horizon_division.hpp"
#include "rules/framework/block_framework.hpp"
#include "rules/framework/walls.hpp"

namespace geomesh::geomodel {

/// The continuation of a horizon in one block. It reaches beyond the block's walls, which cut it later.
struct BlockExtension {
  Index block = no_index;
  std::vector<Vec3> added;          ///< added points, whose rows follow those of the surface
  std::vector<Triangle> triangles;  ///< triangles with the orientation of the surface
  std::vector<Index> walls;         ///< rows of the surfaces that they cross, ascending; Walls::side_of_volume last
  double length = 0;                ///< length in m of the border that is continued
  double farthest = 0;              ///< distance in m between the given parts and the farthest place in the block
  Vec3 place;                       ///< there
};

/// A horizon and its division into fault blocks.
struct DividedHorizon {
  /// For each triangle, false in blocks that are not continued here: those in which a wall ends, and those in which the
  /// horizon has several heights over a place of the map.
  std::vector<bool> is_continued;
  std::vector<bool> block_is_continued;  ///< per block
  std::vector<BlockExtension> extensions;
};

/// The walls and blocks in which a horizon is continued; all that it references must outlive its use.
struct BlockSetting {
  const BlockFramework& framework;
  const Walls& cutters;  ///< faults and bodies
  const Walls& walls;    ///< includes horizons and the sides of the model
  double within = 0;     ///< m
  /// Whether places are filled however far they are from the data of their block.
  bool fills_blocks = false;
  /// For each block, whether the horizon cannot be present there; empty: it can be in all blocks.
  std::vector<bool> is_left_out{};
  /// For horizons that are moved before walls cut them: whether continuations extend beyond walls by one more row of
  /// places, and beyond other horizons as if these were absent.
  bool has_margin = false;
  HeldTriangles held{};
  double slopes_within = within;  ///< m: so far from its data the horizon keeps the slope that it has there
};

/// Continues the horizon in each block, from the edges of its border that have walls in front of them. In the map, a
/// place of the block is filled unless it is covered by a disc of diameter `within` that meets neither given parts nor
/// a wall: gaps narrower than the distance are closed whatever their length, and where the horizon ends in the open its
/// border remains open. The filled area is connected with the border that it continues. Heights are those of the
/// nearest place of the border, extrapolated with its slope up to the distance, or with the sheet's mean slope nearby
/// if blocks are filled. O(n log n) in the triangles, and the product of border edges and grid places in a block.
DividedHorizon continue_in_blocks(const TriangulatedSurface& horizon, Index row, const BorderStates& states,
                                  const BlockSetting& setting);

}  // namespace geomesh::geomodel
