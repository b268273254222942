// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// All horizons of a stack over one triangulation of the map, with as few triangles as the tolerance allows.
#pragma once

#include <vector>

#include "rules/order/column_heights.hpp"
#include "stack/map/map_layout.hpp"
#include "stack/map/map_samples.hpp"
#include "stack/sheets/thin_areas.hpp"

namespace geomesh::geomodel {

/// Share of the allowed distance by which any vertex may move after the sheets were approximated
/// (stack/sheets/sheet_room.hpp).
inline constexpr double share_for_centring = 0.15;

/// Radius within which heights are averaged at a vertex, as a share of the length of its edges.
inline constexpr double fit_of_edge = 0.35;

struct SheetOptions {
  Keepers keepers;                ///< one a pair
  double allowed = 0;             ///< largest vertical distance from the settled heights of samples, in m
  double gap = 0;                 ///< least thickness at vertices where a pair is not merged, in m
  double room_at_pinch_outs = 0;  ///< additional distance allowed in triangles that touch a pinch-out line, in m
  /// Whether vertices are placed a little beside samples: otherwise the edges of sheets that are approximated
  /// separately from data on one grid would nearly coincide.
  bool beside_samples = false;
};

/// Sheets over one triangulation: all horizons have the same vertices in the map, so that none crosses another.
struct MapSheets {
  std::vector<Vec2> points;
  std::vector<double> heights;  ///< heights of all horizons for each point; NaN where a horizon is absent
  std::vector<Triangle> triangles;
  std::vector<MergedPairs> merged;  ///< per triangle
  std::size_t n_horizons = 0;
  double height(VertexIndex v, std::size_t horizon) const { return heights[v * n_horizons + horizon]; }
};

/// Greedy insertion (after Garland and Heckbert 1995) at the place where any horizon is farthest from its data,
/// relative to what is allowed there. A vertex has the height of a plane fitted to the samples around it. The radius of
/// the fit shrinks if the fit itself causes the distance; with radius zero the vertex lies on the given triangles.
/// Finally the crossings of edges in the map are examined, since the difference is linear between them and the
/// vertices. Cost: nearly linear in the samples. Distances are at most (1 - `share_for_centring`) of those allowed.
MapSheets approximate_sheets(const MapSamples& samples, const MapLayout& layout, const std::vector<ThinArea>& areas,
                             const SheetOptions& options);

}  // namespace geomesh::geomodel
