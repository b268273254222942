// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Parts of a surface that run a little beyond a surface on which it is meant to end.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "rules/framework/block_framework.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// Where a surface is meant to end.
struct MeantEnd {
  Index surface;
  std::vector<Index> cutters;
  double limit;                   ///< m
  std::span<const Index> part{};  ///< BuiltRows::part_of_triangle of the surface, or empty
  /// A surface that divides each block on its own; null: it is one whole.
  const BlockFramework* blocks = nullptr;
};

/// Pieces of the surface that hang on the cutters by one side, end freely and reach no further than the limit from the
/// cutters. How far a continuation reaches does not count: what is given decides. A piece on which alone another
/// surface of the soup ends is kept, as is the largest piece in each block: without it nothing would divide the block.
/// O(n log n) in the soup's edges, and O(n) for each piece that ends freely.
std::vector<Piece> overshoots_of(const WorkingSoup& working, const MeantEnd& end);

/// Takes these pieces off the soup; `notes` tell of them. Returns the area, 0 where there are none.
double remove_overshoots(WorkingSoup& working, const MeantEnd& end, const std::string& name,
                         std::vector<std::string>& notes);

}  // namespace geomesh::geomodel
