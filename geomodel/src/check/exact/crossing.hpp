// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Decides exactly how triangles meet and how often a surface winds around a point.
#pragma once

#include <optional>
#include <vector>

#include "check/exact/box_tree.hpp"
#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel::checking {

enum class Meeting {
  proper,    ///< disjoint, or meeting in shared vertices and edges only
  overlap,   ///< coplanar, with an area or a part of an edge in common
  crossing,  ///< with any other point in common
};
/// Classifies how two triangles meet; points are identified by index. Triangles of zero area are `proper` with
/// everything.
Meeting meeting(const std::vector<Vec3>& points, const Triangle& s, const Triangle& t);

/// Returns the winding number of the closed oriented surface `triangles` just outside face f of it (on the side that
/// its normal points to). `tree` is over the triangles' boxes. Expects an embedded surface.
int winding_outside(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, Index f,
                    const BoxTree& tree);

/// Returns the winding number of the closed oriented surface around the centroid of a, b, c; nothing if the centroid is
/// on the surface.
std::optional<int> winding_about_centroid(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                                          const BoxTree& tree, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace geomesh::geomodel::checking
