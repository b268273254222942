// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds parts of a surface that run a little beyond a surface on which it is meant to end.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "rules/framework/block_framework.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// The surfaces at which a surface is meant to end.
struct MeantEnd {
  Index surface;
  std::vector<Index> cutters;
  double limit;                   ///< m
  std::span<const Index> part{};  ///< BuiltRows::part_of_triangle of the surface, or empty
  /// The blocks, if the surface divides each block separately; null if it is one whole.
  const BlockFramework* blocks = nullptr;
};

/// Returns the pieces of the surface that are attached to the cutters on one side, are free elsewhere, and reach no
/// farther than the limit from the cutters. Only the given triangles of a piece are measured, not continuations. A
/// piece on which alone another surface of the soup ends is kept, as is the largest piece in each block: without it
/// nothing would divide the block. O(n log n) in the soup's edges, and O(n) for each piece that ends freely.
std::vector<Piece> overshoots_of(const WorkingSoup& working, const MeantEnd& end);

/// Removes these pieces from the soup and reports them in `notes`. Returns their area, 0 if there are none.
double remove_overshoots(WorkingSoup& working, const MeantEnd& end, const std::string& name,
                         std::vector<std::string>& notes);

}  // namespace geomesh::geomodel
