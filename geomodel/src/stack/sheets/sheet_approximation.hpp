// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Approximates all horizons over one triangulation of the map, with as few triangles as the tolerance allows.
#pragma once

#include <vector>

#include "rules/order/column_heights.hpp"
#include "stack/map/map_layout.hpp"
#include "stack/map/map_samples.hpp"
#include "stack/sheets/thin_areas.hpp"

namespace geomesh::geomodel {

/// Fraction of the allowed distance that the approximation leaves for later moves of vertices
/// (stack/sheets/sheet_room.hpp).
inline constexpr double share_for_centring = 0.15;

/// Radius within which heights are averaged at a vertex, as a fraction of the length of its edges.
inline constexpr double fit_of_edge = 0.35;

struct SheetOptions {
  Keepers keepers;     ///< one a pair
  double allowed = 0;  ///< largest vertical distance in m that is allowed from the samples' ordered heights
  double gap = 0;      ///< least thickness in m at vertices at which a pair of neighbouring horizons is not merged
  double room_at_pinch_outs = 0;  ///< additional distance in m allowed in triangles that touch a pinch-out line
  /// Whether vertices are placed a little beside samples. Otherwise the edges of surfaces that are approximated
  /// separately from data on the same grid would nearly coincide.
  bool beside_samples = false;
};

/// All horizons of a stack over one triangulation. They share vertices in the map, so that none crosses another.
struct MapSheets {
  std::vector<Vec2> points;
  std::vector<double> heights;  ///< heights of all horizons at each point; NaN where a horizon is absent
  std::vector<Triangle> triangles;
  std::vector<MergedPairs> merged;  ///< per triangle
  std::size_t n_horizons = 0;
  double height(VertexIndex v, std::size_t horizon) const { return heights[v * n_horizons + horizon]; }
};

/// Approximates all horizons by greedy insertion (after Garland and Heckbert 1995) of vertices at the place where any
/// horizon is farthest from its data, relative to the distance allowed there. The height at a vertex is that of a plane
/// fitted to the samples around it. The radius of the fit shrinks if the fit itself causes the distance; with radius
/// zero the vertex lies on the input triangles. Finally the crossings of edges in the map are examined, since the
/// difference is linear between them and the vertices. Distances are at most (1 - `share_for_centring`) of those
/// allowed. Cost: nearly linear in the samples.
MapSheets approximate_sheets(const MapSamples& samples, const MapLayout& layout, const std::vector<ThinArea>& areas,
                             const SheetOptions& options);

}  // namespace geomesh::geomodel
