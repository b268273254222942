// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizons given block by block: each block is continued on its own, through the faults that bound it.
#pragma once

#include <vector>

#include "rules/extend/extend.hpp"
#include "rules/throw/fault_crossings.hpp"
#include "rules/throw/sheet_sides.hpp"

namespace geomesh::geomodel {

/// The faults of a horizon and how its blocks are continued to the box.
struct BlockFaults {
  const std::vector<ThrowFault>& faults;
  Extend how;
  const Box3& box;
};

/// Sheets of a horizon whose ramps were taken out; empty lists: not known.
struct KnownSheets {
  std::vector<Index> sheet{};      ///< per triangle: its sheet, or BuiltRows::of_every_block
  std::vector<Triangle> before{};  ///< the horizon's triangles with the ramps
};

/// Blocks of a horizon.
struct SortedBlocks {
  std::vector<Index> of_triangle;
  std::vector<std::vector<bool>> sides{};  ///< per block: whether it lies above each of the faults
};

/// The block of each triangle, from 0 in the order of their first triangles: sheets that lie, for most of their area,
/// on the same sides of all `faults` are one block. Which side is that of the nearest fault triangle's plane; it only
/// sorts sheets, nothing is cut by it.
///
/// Where a fault ends inside the box, beyond its tip the horizon runs on. There its triangles belong to every block
/// (BuiltRows::of_every_block): those given that cross the fault's continuation. Where the sheets on both sides leave
/// a gap there, triangles that join them come too, which are appended to the horizon. What crosses the fault itself,
/// and what lies beyond it without going round its tip, is in no block (BuiltRows::of_no_block): the blocks are
/// continued to the fault in its place.
///
/// With sheets known those of one number are a sheet; else triangles that hang together by edges. What goes round a tip
/// is then known too, and only what joins the sheets beyond the horizon's own border is added.
SortedBlocks sort_into_blocks(TriangulatedSurface& horizon, const BlockFaults& parting, const BuildLog& log,
                              const KnownSheets& known);

/// Whether much of what goes round the faults' ends in the box, or crosses them, lies on sides of them on which no
/// block does. Nothing would be left there once the faults part the horizon. Never where all faults go through.
bool lies_in_no_block(const TriangulatedSurface& horizon, const std::vector<Index>& block,
                      const std::vector<std::vector<bool>>& sides, const BlockFaults& parting);

/// Continues each block to beyond the box as extend_to_box does; `block` grows with the triangles. The blocks then run
/// through each other near the faults; trim_soup ends them there. What lies wholly beyond a fault is left out. What
/// crosses a fault that ends inside at both ends, all about it in one block, comes back to that block as it is. False
/// where a block could not be continued, which a warning tells.
bool extend_blocks(TriangulatedSurface& horizon, std::vector<Index>& block, const BlockFaults& parting,
                   const BuildLog& log);

}  // namespace geomesh::geomodel
