// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Continues a horizon block by block: in each fault block, from the original parts of the horizon there.
#pragma once

#include <vector>

#include "rules/continuation/border_chains.hpp"
#include "rules/framework/block_framework.hpp"
#include "rules/framework/walls.hpp"

namespace geomesh::geomodel {

/// The continuation of a horizon in one block. It reaches beyond the block's bounding surfaces, which cut it later.
struct BlockExtension {
  Index block = no_index;
  std::vector<Vec3> added;          ///< points added to the surface; they are numbered after its own points
  std::vector<Triangle> triangles;  ///< triangles added to the surface, with its orientation
  /// Indices of the surfaces that the continuation's triangles cross, ascending; Walls::side_of_volume last.
  std::vector<Index> walls;
  double length = 0;  ///< length in m of the horizon's border that is continued in the block
  /// Distance in m between the horizon's original parts and the farthest place of the block to which it was continued.
  double farthest = 0;
  Vec3 place;  ///< there
};

/// The result of continuing a horizon in its fault blocks.
struct DividedHorizon {
  /// For each triangle, whether its block was continued. False in blocks in which a bounding surface ends, and in
  /// blocks in which the horizon has several heights over a place of the map.
  std::vector<bool> is_continued;
  std::vector<bool> block_is_continued;  ///< per block
  std::vector<BlockExtension> extensions;
};

/// The bounding surfaces and blocks in which a horizon is continued. All referenced data must outlive this object.
struct BlockSetting {
  const BlockFramework& framework;
  const Walls& cutters;  ///< faults and bodies
  const Walls& walls;    ///< surfaces at which continuations end: faults, bodies, horizons, model sides
  double within = 0;     ///< m
  /// Whether horizons are continued through each whole block, however far that is from their data in the block.
  bool fills_blocks = false;
  /// For each block, whether the horizon must be absent from it; empty if it may be present in all blocks.
  std::vector<bool> is_left_out{};
  /// Whether continuations extend beyond bounding surfaces by one more row of grid points, and beyond other horizons as
  /// if these were absent. Set for horizons that are moved before bounding surfaces cut them.
  bool has_margin = false;
};

/// Continues the horizon in each block, from the edges of its border that have bounding surfaces in front of them. A
/// place of the block in the map is filled unless it is covered by a disc of diameter `within` that meets neither the
/// horizon nor a bounding surface. Gaps narrower than this diameter are therefore closed whatever their length, and a
/// border in the open remains open. The filled area is connected with the border that it continues. Heights are those
/// of the nearest place of the border, extrapolated with its slope up to the distance, or with the mean slope of the
/// horizon nearby if blocks are filled. O(n log n) in the triangles, and the product of border edges and grid points in
/// a block.
DividedHorizon continue_in_blocks(const TriangulatedSurface& horizon, Index row, const BorderStates& states,
                                  const BlockSetting& setting);

}  // namespace geomesh::geomodel
