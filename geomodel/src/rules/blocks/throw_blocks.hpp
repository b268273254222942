// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizons given block by block: each block is extended on its own through the faults that bound it.
#pragma once

#include <vector>

#include "rules/extend/extend.hpp"
#include "rules/throw/fault_crossings.hpp"
#include "rules/throw/sheet_sides.hpp"

namespace geomesh::geomodel {

/// The faults of a horizon, and how its blocks are extended to the box.
struct BlockFaults {
  const std::vector<ThrowFault>& faults;
  Extend how;
  const Box3& box;
};

/// The sheets of a horizon after its ramps were removed; empty lists if they are not known.
struct KnownSheets {
  std::vector<Index> sheet{};      ///< for each triangle its sheet, or BuiltRows::of_every_block
  std::vector<Triangle> before{};  ///< the horizon's triangles before ramps were removed
};

/// The blocks of a horizon and the faults that bound them.
struct SortedBlocks {
  std::vector<Index> of_triangle;
  std::vector<std::vector<bool>> sides{};  ///< for each block: whether it lies above each of the faults
  /// Row of the first triangle that was added to join blocks beyond the tip of a fault; they are the last.
  Index first_joining = no_index;
  /// Triangles of the same triangulation that cross no extension of a fault.
  std::vector<Triangle> beside_joining{};
};

/// Assigns each triangle to a block, numbered from 0 in the order of their first triangles: sheets whose area lies
/// mostly on the same sides of all `faults` form one block. The side is that of the plane of the nearest fault
/// triangle, which is exact enough to sort sheets, since nothing is cut by it. If a fault ends inside the box, the
/// horizon continues beyond its tip. The given triangles that cross the fault's extension there belong to every block
/// (BuiltRows::of_every_block). If the sheets on both sides leave a gap there, triangles that connect them are appended
/// to the horizon and belong to every block too. Triangles that cross the fault itself, or lie beyond it without
/// continuing around its tip, are in no block (BuiltRows::of_no_block); the blocks are extended to the fault instead.
/// With known sheets, triangles with the same number form a sheet. The triangles around a tip are known too in this
/// case, and only those are added that connect sheets beyond the horizon's own border. Without known sheets, a sheet is
/// a set of triangles connected by edges.
SortedBlocks sort_into_blocks(TriangulatedSurface& horizon, const BlockFaults& parting, const BuildLog& log,
                              const KnownSheets& known);

/// Returns whether a large part of the triangles that cross the faults, or lie around their ends, lies on sides of the
/// faults where there is no block. Nothing would be left there after the faults divide the horizon. False if all faults
/// go through the whole model.
bool lies_in_no_block(const TriangulatedSurface& horizon, const std::vector<Index>& block,
                      const std::vector<std::vector<bool>>& sides, const BlockFaults& parting);

/// Extends each block beyond the box as extend_to_box does; the block of each added triangle is appended to `sorted`.
/// The blocks then cross each other near the faults; trim_soup cuts them off there. Parts entirely beyond a fault are
/// left out. Triangles that cross a fault with both ends inside the model, and that one block surrounds, are returned
/// to this block unchanged; so are triangles of SortedBlocks::beside_joining that one block and the joining triangles
/// surround. Returns false, with a warning, if a block could not be extended.
bool extend_blocks(TriangulatedSurface& horizon, SortedBlocks& sorted, const BlockFaults& parting, const BuildLog& log);

}  // namespace geomesh::geomodel
