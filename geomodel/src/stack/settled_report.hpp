// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reports what changed when a stack of horizons was put in order: areas, moves and thicknesses.
#pragma once

#include <functional>

#include "geomesh/geomodel/stack.hpp"
#include "geomesh/geomodel/tolerance_ledger.hpp"
#include "stack/sheets/sheet_approximation.hpp"
#include "stack/throw/fault_strips.hpp"

namespace geomesh::geomodel {

/// The data and the options from which horizons were put in order.
struct SettledFrom {
  const MapSamples& samples;
  const std::vector<ThinArea>& areas;
  MapBounds bounds;  ///< bounds of the maps of thickness
  const SheetOptions& options;
  /// Strips along faults in which moves are not measured, since the heights there are the mean of both sides.
  const FaultStrips& strips;
  /// Whether the first horizon is the topography; parts of others above it are cut off and do not count as moved.
  bool has_topography;
  std::function<bool(const Vec3&)> counts{};  ///< whether a place counts for reported areas and moves; empty: all do
};

/// Reports what changed when the horizons were put in order, without names, numbers of triangles and changes along
/// faults.
SettledStack describe_settled(const MapSheets& sheets, const SettledFrom& from);

/// Returns one sentence for each horizon that was moved and each unit that thins out.
std::vector<std::string> notes_of(const SettledStack& stack);

/// Returns how much of the tolerance was used: by the approximation of the horizons, with the largest distance measured
/// from their points; and separately by the moves that order and thickness required, one entry per horizon.
std::vector<ToleranceUse> uses_of(const SettledStack& stack);

}  // namespace geomesh::geomodel
