// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Settled sheets in the strips along faults with throw: each horizon is built from both sides, in the right order on
/// each.
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
  std::vector<Index> rows{};  ///< rows of the faults' surfaces, by which common faults of two horizons are recognised
  std::vector<std::vector<bool>> sides{};  ///< for each block: whether it lies above each of the faults
};

/// The input from which strips are made; all of it must outlive the call.
struct StripInput {
  const std::vector<BlockData>& horizons;    ///< in the frame
  const std::vector<HorizonFaults>& faults;  ///< faults of each horizon, in model coordinates
  const FaultStrips& strips;
  const MapFrame& frame;
  const Box3& box;
  const SheetOptions& options;
};

/// One horizon with throw, in the coordinate frame of the map.
struct SidedHorizon {
  std::vector<Vec3> points;
  /// Counter-clockwise triangles; first those with one height, then those with two sides.
  std::vector<Triangle> triangles;
  std::vector<Index> block;  ///< block of each triangle, as in BuiltRows
  Index n_single = 0;        ///< number of triangles with one height
  double area = 0;           ///< area of the strips in the map
  double largest_move = 0;   ///< largest move in the strips that was needed to restore the order
  Vec3 place;
  /// Largest move against the rules, by which the horizon keeps its place and another one, which has no throw there,
  /// should have been moved.
  double largest_against_rule = 0;
};

/// A triangle that crosses a fault is present once on each side of it. Its vertices have the heights of the block on
/// that side. They are put in order with the blocks of other horizons on the same sides of all common faults. A horizon
/// that has no throw there keeps its place. Vertices of triangles with one height keep that height. Triangles that
/// cross the extension of a fault beyond its tip belong to every block and have one height. If the sheets have no
/// height in the strips, the mean of both sides is used. Horizons without throw have an empty entry in the result.
/// Cost: about linear in the strips' triangles times the blocks that reach them.
std::vector<SidedHorizon> make_both_sides(MapSheets& sheets, const StripInput& input);

}  // namespace geomesh::geomodel
