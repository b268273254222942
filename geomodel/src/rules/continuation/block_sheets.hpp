// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A horizon continued block by block: in each fault block from what is given of it there.
#pragma once

#include <vector>

#include "rules/continuation/border_chains.hpp"
#include "rules/continuation/horizon_division.hpp"
#include "rules/framework/block_framework.hpp"
#include "rules/framework/walls.hpp"

namespace geomesh::geomodel {

/// What continues a horizon in one block. It reaches beyond the block's walls, which cut it later.
struct BlockExtension {
  Index block = no_index;
  std::vector<Vec3> added;          ///< points, with rows after the surface's own
  std::vector<Triangle> triangles;  ///< oriented as the surface is
  std::vector<Index> walls;         ///< surfaces that they run through, ascending; Walls::side_of_volume last
  double length = 0;                ///< of the border that goes on, m
  double farthest = 0;              ///< distance of the farthest place in the block from what is given, m
  Vec3 place;                       ///< there
};

/// The horizon as the framework divides it.
struct DividedHorizon {
  /// Per triangle, false in blocks that extensions do not continue: where a wall ends inside the block, and where the
  /// horizon has several heights over a place of it.
  std::vector<bool> is_continued;
  std::vector<bool> block_is_continued;  ///< per block
  std::vector<BlockExtension> extensions;
};

/// In what a horizon is continued; all but the last outlive its use.
struct BlockSetting {
  const BlockFramework& framework;
  const Walls& cutters;  ///< faults and bodies
  const Walls& walls;    ///< horizons and the sides, too
  double within = 0;     ///< m
  /// Places are filled however far from the data of their block they are.
  bool fills_blocks = false;
  std::vector<bool> is_left_out{};  ///< per block: the horizon has no place there; empty: none
  /// For horizons that are moved before walls cut them: extensions go on beyond walls by a further row of places, and
  /// beyond other horizons as if these were not there.
  bool has_margin = false;
  HeldTriangles held{};
  double slopes_within = within;  ///< m: so far from its data the horizon keeps the slope that it has there
};

/// Continues the horizon in each block, from the edges of its border that have walls before them. In the map, a place
/// of the block is filled unless a disc of diameter `within` that meets neither what is given nor a wall covers it:
/// gaps narrower than the distance are closed whatever their length, and where the horizon ends in the open its border
/// stays open. What is filled hangs together with the border that it continues. Heights are those of the nearest place
/// of the border, with its slope up to the distance, or the sheet's mean slope near it where blocks are filled. O(n log
/// n) in the triangles, and the product of border edges and grid places in a block.
DividedHorizon continue_in_blocks(const TriangulatedSurface& horizon, Index row, const BorderStates& states,
                                  const BlockSetting& setting);

}  // namespace geomesh::geomodel
