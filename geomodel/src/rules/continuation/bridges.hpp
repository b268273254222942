// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Gaps inside a horizon that no fault or body explains: holes, undefined strips, parts that do not quite meet.
#pragma once

#include <functional>

#include "rules/framework/fault_tip.hpp"
#include "rules/framework/walls.hpp"
#include "rules/planar/borders.hpp"

namespace geomesh::geomodel {

/// Frames in which a horizon with faults that end in it has one height at a place: the map, then along the dip of each
/// fault with a tip at the horizon's heights. Both sides of a reverse fault overlap in the map, and lie beside each
/// other as seen along its dip.
std::vector<Frame> frames_along(const TriangulatedSurface& surface, const std::vector<FaultTip>& tips);

/// Between what gaps are filled, and which; all but the numbers outlive its use.
struct GapSetting {
  const Walls& walls;
  const std::vector<FaultTip>& tips;
  const std::vector<Frame>& frames;
  Box3 box;
  double within = 0;                        ///< m
  std::function<bool(const Vec3&)> counts;  ///< whether a place is to be filled
  bool holes_alone = false;                 ///< gaps that the border encloses, and no others
};

/// Fills what lies between borders of the surface in the map with the triangles of the borders' constrained Delaunay
/// triangulation whose circumcircle has a radius of at most `within` and whose sides cross no wall. Where the tip of a
/// wall ends in such a triangle it becomes a point of the surface, so that what is filled begins exactly at the tip.
/// Only triangles whose centroid `counts` accepts are added. The first of the frames is used in which borders do not
/// cross; a surface with several heights over a place in all of them is filled part by part. Appends to the surface;
/// rows as given stay.
void bridge_gaps(TriangulatedSurface& surface, const GapSetting& setting);

/// Another horizon pierces a hole where it lies below the border of the hole all along and above it inside, or the
/// other way round: it bounds the units there itself, as a basement high or the base of a channel does. Of the
/// triangles from row `first` on, which fill holes of horizon `row`, takes out those that such a horizon meets or that
/// lie beyond it. `model`: the box of the model. O(n log n) in the triangles of the horizon, and searches among the
/// walls for those that are filled.
void open_where_pierced(TriangulatedSurface& horizon, Index row, Index first, const Walls& walls, const Box3& model);

}  // namespace geomesh::geomodel
