// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds where a unit of a stack is too thin to be meshed: the areas in which its two horizons are merged.
#pragma once

#include <vector>

#include "rules/order/column_heights.hpp"
#include "stack/map/map_raster.hpp"

namespace geomesh::geomodel {

struct ThinAreaOptions {
  double size = 0;       ///< target edge length in the map in m, at which pinch-out lines are smooth
  double thickness = 0;  ///< least thickness of a unit, in m
  double shift = 0;      ///< distance by which pinch-out lines are moved into the merged area, in m
};

/// One pair of neighbouring horizons of the stack.
struct ThinArea {
  MapRaster excess;                       ///< thickness minus the least thickness, negative where the pair is merged
  std::vector<std::vector<Vec2>> curves;  ///< pinch-out lines, in pieces of about the size
  std::size_t n_islands = 0;              ///< number of removed islands, which were too small to be merged or kept
  bool any() const;
};

/// Returns one entry per pair. Thicknesses are averaged over about half of the target size, so that noise between nodes
/// makes no islands. An area is merged if the thickness falls below three quarters of the least thickness somewhere in
/// it. An opening in it is kept if the thickness exceeds one and a half times the least thickness. Both need at least
/// two squares of the size, except openings thicker than three times the least thickness. Pinch-out lines preserve the
/// areas on their sides, apart from the shift.
std::vector<ThinArea> find_thin_areas(const MapSamples& samples, const MapBounds& bounds, const Keepers& keepers,
                                      const ThinAreaOptions& options);

}  // namespace geomesh::geomodel
