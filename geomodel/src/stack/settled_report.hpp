// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What settling a stack changed, with areas, moves and thicknesses.
#pragma once

#include <functional>

#include "geomesh/geomodel/stack.hpp"
#include "geomesh/geomodel/tolerance_ledger.hpp"
#include "stack/sheets/sheet_approximation.hpp"

namespace geomesh::geomodel {

/// What sheets were settled from and how.
struct SettledFrom {
  const MapSamples& samples;
  const std::vector<ThinArea>& areas;
  MapBounds bounds;  ///< of the maps of thickness
  const SheetOptions& options;
  bool has_topography;                        ///< the first horizon: what lies over it is cut off, which is no move
  std::function<bool(const Vec3&)> counts{};  ///< whether a place of the frame counts; empty: all do
};

/// Names, counts of triangles and what happened along faults are left to the caller.
SettledStack describe_settled(const MapSheets& sheets, const SettledFrom& from);

/// A sentence a horizon that was moved and a unit that thins out.
std::vector<std::string> notes_of(const SettledStack& stack);

/// What settling used of the tolerance: the share that approximating the horizons may use, with the largest distance
/// measured from their points; and, apart from it, moves that order and thickness required, one entry a horizon.
std::vector<ToleranceUse> uses_of(const SettledStack& stack);

}  // namespace geomesh::geomodel
