// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the areas in which a unit of a stack is too thin to be meshed, so that its two horizons are merged.
#pragma once

#include <vector>

#include "rules/order/column_heights.hpp"
#include "stack/map/map_raster.hpp"

namespace geomesh::geomodel {

struct ThinAreaOptions {
  double size = 0;       ///< target edge length in the map in m; pinch-out lines are smooth at this scale
  double thickness = 0;  ///< least thickness of a unit, in m
  double shift = 0;      ///< distance in m by which pinch-out lines are moved into the area where horizons are merged
};

/// The thin areas between one pair of neighbouring horizons of the stack.
struct ThinArea {
  MapRaster excess;  ///< thickness minus the least thickness, negative where the two horizons are merged
  std::vector<std::vector<Vec2>> curves;  ///< pinch-out lines, in pieces of about the target size
  /// Number of thin areas too small to be merged, and of openings in thin areas too small to be kept.
  std::size_t n_islands = 0;
  bool any() const;
};

/// Finds where neighbouring horizons are merged; returns one entry per pair. Thicknesses are averaged over about half
/// of the target size, so that noise between nodes makes no islands. An area is merged if the thickness falls below
/// three quarters of the least thickness somewhere in it. An opening in a merged area is kept if the thickness exceeds
/// one and a half times the least thickness. Both need an area of at least two squares of the target size, except
/// openings thicker than three times the least thickness. Pinch-out lines preserve the areas on their sides, apart from
/// the shift.
std::vector<ThinArea> find_thin_areas(const MapSamples& samples, const MapBounds& bounds, const Keepers& keepers,
                                      const ThinAreaOptions& options);

}  // namespace geomesh::geomodel
