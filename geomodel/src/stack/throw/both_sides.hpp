// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Builds the horizons with throw in the strips along their faults: from both sides, in the right order on each side.
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
  std::vector<Index> rows{};  ///< indices of the faults' surfaces, by which two horizons' common faults are recognised
  std::vector<std::vector<bool>> sides{};  ///< for each block: whether it lies above each of the faults
};

/// The input for horizons in strips along faults. All referenced data must outlive the call.
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
  /// Counter-clockwise triangles: first those with a single height, then those that exist on both sides of a fault.
  std::vector<Triangle> triangles;
  std::vector<Index> block;  ///< fault block of each triangle, as in BuiltRows
  Index n_single = 0;        ///< number of triangles with one height; the others exist once on each side of a fault
  double area = 0;           ///< area in the map of the strips along faults
  double largest_move = 0;   ///< largest move in the strips along faults that restoring the order required
  Vec3 place;
  /// Largest move in m that violates the rules: this horizon should keep its height, but the horizon that should move
  /// instead has no throw at that place.
  double largest_against_rule = 0;
};

/// Makes horizons with throw in the strips along their faults. A triangle that crosses a fault exists once on each side
/// of it, with the heights of the block on that side. These heights are put in order with those of the blocks of other
/// horizons on the same sides of all common faults. A horizon without throw in the strip keeps its height. Vertices
/// shared with triangles that have a single height keep that height. Triangles that cross the extension of a fault
/// beyond its tip belong to every block and have one height. Where `sheets` has no height in the strips, it gets the
/// mean of both sides. Horizons without throw have an empty entry in the result. Cost: about linear in the strips'
/// triangles times the blocks that reach them.
std::vector<SidedHorizon> make_both_sides(MapSheets& sheets, const StripInput& input);

}  // namespace geomesh::geomodel
