// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Prepares horizons with throw as data of the map: their blocks, and the areas where only one block is present.
#pragma once

#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// A horizon of a stack. Without throw, it consists of the surface `single` only.
struct BlockData {
  /// Triangles without another block above or below. For original triangles, those made by rules do not count.
  TriangulatedSurface single;
  std::vector<Index> block_of_single{};  ///< fault block of each triangle, as in BuiltRows
  /// All triangles of each block, including those that belong to every block and the block's extension through its
  /// faults.
  std::vector<TriangulatedSurface> blocks{};
  bool has_throw() const { return !blocks.empty(); }
};

/// Collects the data of a horizon, divided into blocks. `block_of` is as in BuiltRows; if empty, the horizon has no
/// throw. Triangles from index `n_given` on were made by rules. Overlaps are tested at a few places per triangle. Cost:
/// about linear in triangles times blocks.
BlockData block_data(const TriangulatedSurface& horizon, const std::vector<Index>& block_of, Index n_given);

/// Returns whether the original triangles of each block have one height over each place of the map.
bool is_single_valued_by_block(const TriangulatedSurface& horizon, const std::vector<Index>& block_of, Index n_given);

}  // namespace geomesh::geomodel
