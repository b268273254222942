// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Settled sheets in the strips along faults with throw: each horizon from both sides, in order on each.
#pragma once

#include <vector>

#include "rules/throw/fault_crossings.hpp"
#include "stack/map/map_frame.hpp"
#include "stack/sheets/sheet_approximation.hpp"
#include "stack/throw/block_data.hpp"
#include "stack/throw/fault_strips.hpp"

namespace geomesh::geomodel {

/// The faults of a horizon with throw.
struct HorizonFaults {
  std::vector<ThrowFault> faults{};
  std::vector<Index> rows{};               ///< of their surfaces, by which horizons have a fault in common
  std::vector<std::vector<bool>> sides{};  ///< per block: whether it lies above each of them
};

/// What the strips are made from; all outlive the call.
struct StripInput {
  const std::vector<BlockData>& horizons;    ///< in the frame
  const std::vector<HorizonFaults>& faults;  ///< per horizon, in the model
  const FaultStrips& strips;
  const MapFrame& frame;
  const Box3& box;
  const SheetOptions& options;
};

/// One horizon with throw, in the frame.
struct SidedHorizon {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;  ///< counter-clockwise; first those of one height, then those of both sides
  std::vector<Index> block;         ///< per triangle, as in BuiltRows
  Index n_single = 0;               ///< triangles of one height
  double area = 0;                  ///< in the map, of the strips
  double largest_move = 0;          ///< that order took, in the strips
  Vec3 place;
  /// What it moved at most where the rules say that it stays, and another one, which has no throw there, gives way.
  double largest_against_rule = 0;
};

/// A triangle that crosses a fault is there once on each side of it. Its vertices have the heights of the block of that
/// side. They are put in order with the blocks of other horizons on the same sides of all faults that both know. A
/// horizon that has no throw there keeps its place. Vertices of triangles with one height keep that. Triangles that
/// cross the continuation of a fault beyond its end are of every block, and have one height.
///
/// What the sheets have no height for in the strips gets the mean of both sides. Horizons without throw have an empty
/// entry in the result. Cost: about linear in the strips' triangles times the blocks that reach them.
std::vector<SidedHorizon> make_both_sides(MapSheets& sheets, const StripInput& input);

}  // namespace geomesh::geomodel
