// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizons with throw as data of the map: their blocks, and where one of these alone is there.
#pragma once

#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// A horizon of a stack. Without throw it is `single` alone.
struct BlockData {
  TriangulatedSurface single;                 ///< triangles over which no other block lies; given ones may have what
                                              ///< was made of another block over them
  std::vector<Index> block_of_single{};       ///< per triangle, as in BuiltRows
  std::vector<TriangulatedSurface> blocks{};  ///< each with what is of every block, and on through its faults
  bool has_throw() const { return !blocks.empty(); }
};

/// `block_of`: as in BuiltRows; empty: no throw. Triangles from `n_given` on were made by rule. What overlaps is told
/// by a few places a triangle. Cost: about linear in triangles times blocks.
BlockData block_data(const TriangulatedSurface& horizon, const std::vector<Index>& block_of, Index n_given);

/// Each block as it was given has one height over each place of the map.
bool is_single_valued_by_block(const TriangulatedSurface& horizon, const std::vector<Index>& block_of, Index n_given);

}  // namespace geomesh::geomodel
