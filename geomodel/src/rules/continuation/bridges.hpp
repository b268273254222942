// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Gaps inside a horizon that no fault or body explains: holes, undefined strips, parts that do not quite meet.
#pragma once

#include <functional>

#include "rules/continuation/walls.hpp"
#include "rules/planar/borders.hpp"
#include "rules/planar/reach.hpp"

namespace geomesh::geomodel {

/// What was filled.
struct Bridged {
  std::size_t n_triangles = 0;
  double area = 0;  ///< m2
  Vec3 place;       ///< of the largest triangle
};

/// Fills what lies between borders of the surface in the map with the triangles of the borders' constrained Delaunay
/// triangulation whose circumcircle has a radius of at most `within` and whose sides cross no wall. Where the tip of a
/// wall ends in such a triangle it becomes a point of the surface, so that what is filled begins exactly at the tip.
/// Only triangles whose centroid `counts` accepts are added. A surface with several heights over a place is filled part
/// by part. Appends to the surface; rows as given stay.
Bridged bridge_gaps(TriangulatedSurface& surface, const Walls& walls, const std::vector<EdgeEnds>& tips,
                    const Box3& box, double within, const std::function<bool(const Vec3&)>& counts);

}  // namespace geomesh::geomodel
