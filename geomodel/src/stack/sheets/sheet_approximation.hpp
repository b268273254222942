// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// All horizons of a stack over one triangulation of the map, with as few triangles as their tolerance allows.
#pragma once

#include <vector>

#include "rules/order/column_heights.hpp"
#include "stack/map/map_layout.hpp"
#include "stack/map/map_samples.hpp"
#include "stack/sheets/thin_areas.hpp"

namespace geomesh::geomodel {

/// Of the distance that is allowed: what any vertex may move by once the sheets are there
/// (stack/sheets/sheet_room.hpp).
inline constexpr double share_for_centring = 0.15;

/// Radius within which heights are averaged at a vertex, as a share of the length of edges there.
inline constexpr double fit_of_edge = 0.35;

struct SheetOptions {
  Keepers keepers;                ///< one a pair
  double allowed = 0;             ///< largest distance along the vertical from the settled heights of samples, m
  double gap = 0;                 ///< least thickness at vertices where a pair shares no surface, m
  double room_at_pinch_outs = 0;  ///< further distance allowed in triangles that touch a pinch-out line, m
  bool beside_samples = false;    ///< vertices lie a little beside samples: edges of sheets that are drawn apart from
                                  ///< data on one grid would lie over each other up to rounding
};

/// Sheets over one triangulation: horizons have the same vertices in the map, so that none crosses another.
struct MapSheets {
  std::vector<Vec2> points;
  std::vector<double> heights;  ///< per point one a horizon; NaN where it is not there
  std::vector<Triangle> triangles;
  std::vector<MergedPairs> merged;  ///< per triangle
  std::size_t n_horizons = 0;
  double height(VertexIndex v, std::size_t horizon) const { return heights[v * n_horizons + horizon]; }
};

/// Greedy insertion (after Garland and Heckbert 1995) of the place where any horizon is furthest off, relative to what
/// is allowed there. A vertex has the height of a plane fitted to the samples about it. The radius of the fit shrinks
/// where the fit is what is off; at radius zero it lies on the given triangles. At last the crossings of edges in the
/// map are looked at, between which and the vertices the difference is linear. Cost: near-linear in the samples.
/// Distances are at most (1 - `share_for_centring`) of those allowed.
MapSheets approximate_sheets(const MapSamples& samples, const MapLayout& layout, const std::vector<ThinArea>& areas,
                             const SheetOptions& options);

}  // namespace geomesh::geomodel
