// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Extends horizons with throw block by block, each block on its own through the faults that bound it.
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

/// The connected parts of a horizon after its ramps were removed; empty lists if they are not known.
struct KnownSheets {
  std::vector<Index> sheet{};      ///< for each triangle: connected part of the horizon, or BuiltRows::of_every_block
  std::vector<Triangle> before{};  ///< triangles of the horizon before ramps were removed
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

/// Assigns each triangle of a horizon to a block. Connected parts ("sheets") whose area lies mostly on the same sides
/// of all `faults` form one block; blocks are numbered in the order of their first triangles. The plane of the nearest
/// fault triangle decides the side, which is exact enough because nothing is cut by it. If a fault ends inside the box,
/// the horizon continues beyond its tip: triangles that cross the fault's extension belong to every block
/// (BuiltRows::of_every_block). If the blocks on both sides leave a gap at the extension, connecting triangles that
/// belong to every block are appended to the horizon. Triangles that cross the fault itself, or lie beyond it without
/// continuing around its tip, are in no block (BuiltRows::of_no_block); the blocks are extended to the fault instead.
/// If `known` lists sheets, it gives the triangles around tips too, and only triangles that connect sheets beyond the
/// horizon's border are added.
SortedBlocks sort_into_blocks(TriangulatedSurface& horizon, const BlockFaults& parting, const BuildLog& log,
                              const KnownSheets& known);

/// Returns whether more than a fiftieth of the horizon's area in the box lies on triangles that cross faults or lie
/// around their ends, and there on sides of the faults without a block. The horizon would have a hole there after the
/// faults divide it. Returns false if all faults cross the whole model.
bool lies_in_no_block(const TriangulatedSurface& horizon, const std::vector<Index>& block,
                      const std::vector<std::vector<bool>>& sides, const BlockFaults& parting);

/// Extends each block beyond the box with the rule of extend_to_box(); the block of each new triangle is appended to
/// `sorted`. The blocks then cross each other near the faults, where trim_soup() cuts them off. Parts entirely beyond a
/// fault are left out. Triangles that cross a fault with both ends inside the model, and that one block surrounds, are
/// returned to this block unchanged; so are triangles of SortedBlocks::beside_joining that one block and the joining
/// triangles surround. Returns false, with a warning, if a block could not be extended.
bool extend_blocks(TriangulatedSurface& horizon, SortedBlocks& sorted, const BlockFaults& parting, const BuildLog& log);

}  // namespace geomesh::geomodel
