// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reports what settling a stack changed: areas, moves and thicknesses.
#pragma once

#include <functional>

#include "geomesh/geomodel/stack.hpp"
#include "geomesh/geomodel/tolerance_ledger.hpp"
#include "stack/sheets/sheet_approximation.hpp"

namespace geomesh::geomodel {

/// The data and the options from which sheets were settled.
struct SettledFrom {
  const MapSamples& samples;
  const std::vector<ThinArea>& areas;
  MapBounds bounds;  ///< bounds of the maps of thickness
  const SheetOptions& options;
  bool has_topography;
  std::function<bool(const Vec3&)> counts{};  ///< whether a place of the frame counts; empty: all places count
};

/// Returns the report without names, counts of triangles and changes along faults, which the caller adds.
SettledStack describe_settled(const MapSheets& sheets, const SettledFrom& from);

/// Returns one sentence for each horizon that was moved and each unit that thins out.
std::vector<std::string> notes_of(const SettledStack& stack);

/// Returns what settling used of the tolerance: the share for approximating the horizons, with the largest distance
/// measured from their points; and separately the moves that order and thickness required, one entry per horizon.
std::vector<ToleranceUse> uses_of(const SettledStack& stack);

}  // namespace geomesh::geomodel
