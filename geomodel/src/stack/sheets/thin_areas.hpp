// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Where a unit of a stack is too thin to be one: the areas in which its two horizons share one surface.
#pragma once

#include <vector>

#include "rules/order/column_heights.hpp"
#include "stack/map/map_raster.hpp"

namespace geomesh::geomodel {

struct ThinAreaOptions {
  double size = 0;       ///< edge length asked in the map, m: pinch-out lines are smooth at it
  double thickness = 0;  ///< least thickness of a unit, m
  double shift = 0;      ///< of pinch-out lines into the shared area, m
};

/// One pair of neighbours of the stack.
struct ThinArea {
  MapRaster excess;                       ///< thickness less the least one, negative where the pair shares one surface
  std::vector<std::vector<Vec2>> curves;  ///< pinch-out lines, in pieces of about the size
  std::size_t n_islands = 0;              ///< areas too small to be shared or to stand alone, which went
  bool any() const;
};

/// One entry a pair. Thicknesses are averaged over about half of the size, so that noise from node to node makes no
/// islands. An area is shared where the thickness falls below three quarters of the least one somewhere in it. An
/// opening in it stays where the thickness exceeds one and a half times the least one; both only from ten squares of
/// the size on, but for openings thicker than three times the least. Pinch-out lines keep the areas on their sides, but
/// for the shift.
std::vector<ThinArea> find_thin_areas(const MapSamples& samples, const MapBounds& bounds, const Keepers& keepers,
                                      const ThinAreaOptions& options);

}  // namespace geomesh::geomodel
