// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Closes gaps in a horizon that no fault or body explains: holes, undefined strips, and parts that do not quite meet.
#pragma once

#include <functional>

#include "rules/framework/fault_tip.hpp"
#include "rules/framework/walls.hpp"
#include "rules/planar/borders.hpp"

namespace geomesh::geomodel {

/// Returns frames (planes of projection) in which a horizon with faults that end in it has one height at each place:
/// the map, then projections along the dip of each fault that has a tip at the horizon's heights. The two sides of a
/// reverse fault overlap in the map, but lie side by side when projected along its dip.
std::vector<Frame> frames_along(const TriangulatedSurface& surface, const std::vector<FaultTip>& tips);

/// Limits for filling gaps, and the surfaces between which they are filled. Referenced data must outlive this object.
struct GapSetting {
  const Walls& walls;
  const std::vector<FaultTip>& tips;
  const std::vector<Frame>& frames;
  Box3 box;
  double within = 0;                        ///< m
  std::function<bool(const Vec3&)> counts;  ///< whether a triangle with its centroid at a place may be added
  bool holes_alone = false;                 ///< whether only gaps enclosed by the surface's border are filled
};

/// Fills the areas between borders of the surface in the map with triangles of the borders' constrained Delaunay
/// triangulation whose circumradius is at most `within` and whose sides cross no wall (bounding surface). If the tip of
/// a wall ends in such a triangle, it becomes a point of the surface, so that the filled area begins exactly at the
/// tip. Only triangles whose centroid `counts` accepts are added. The first frame in which borders do not cross is
/// used; if there is none, each connected part of the surface is filled separately. Existing triangles do not change.
void bridge_gaps(TriangulatedSurface& surface, const GapSetting& setting);

/// Triangles from index `first` on fill holes of horizon `row`. Removes those that meet another horizon which pierces
/// the hole, or that lie beyond it. A horizon pierces a hole if it lies below the hole's border all along and above the
/// hole inside, or vice versa. It then bounds the units there itself, as a basement high or the base of a channel does.
/// `model` is the box of the model. O(n log n) in the triangles of the horizon, and one search among the bounding
/// surfaces for each triangle that fills a hole.
void open_where_pierced(TriangulatedSurface& horizon, Index row, Index first, const Walls& walls, const Box3& model);

}  // namespace geomesh::geomodel
