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

/// A surface, and the surfaces (cutters) at which it is meant to end.
struct MeantEnd {
  Index surface;
  std::vector<Index> cutters;
  double limit;  ///< m
  /// For each surface triangle: 0 if original, else the run of border that it continues; empty if none was continued.
  std::span<const Index> part{};
  /// The fault blocks, if the surface divides each of them separately; null otherwise.
  const BlockFramework* blocks = nullptr;
};

/// Returns the pieces of the surface that are attached to the cutters on one side, are free elsewhere, and reach no
/// farther than the limit from the cutters. Only the original triangles of a piece are measured, not continuations. A
/// piece on which another surface ends, and ends on nothing else, is kept. The largest piece in each block is kept,
/// too, since it divides the block. O(n log n) in the soup's edges, and O(n) for each piece that ends freely.
std::vector<Piece> overshoots_of(const WorkingSoup& working, const MeantEnd& end);

/// Removes the pieces that overshoots_of() returns, and notes them. Returns their area, 0 if there are none.
double remove_overshoots(WorkingSoup& working, const MeantEnd& end, const std::string& name,
                         std::vector<std::string>& notes);

}  // namespace geomesh::geomodel
