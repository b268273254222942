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
  proper,    ///< The two triangles are disjoint, or meet in shared vertices and edges only.
  overlap,   ///< The two triangles are coplanar and share an area or a part of an edge.
  crossing,  ///< The triangles share a point inside one or inside an edge of one: they cross, or one touches the other.
};
/// Classifies how the triangles s and t meet. Corners are equal if they have equal indices. If s or t has zero area,
/// the result is `proper`.
Meeting meeting(const std::vector<Vec3>& points, const Triangle& s, const Triangle& t);

/// Returns the winding number of the closed oriented surface `triangles` at a point just outside face f, on the side to
/// which its normal points. `tree` is over the triangles' boxes. Precondition: the surface is embedded.
int winding_outside(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, Index f,
                    const BoxTree& tree);

/// Returns the winding number of the closed oriented surface around the centroid of the triangle a b c; nothing if the
/// centroid is on the surface.
std::optional<int> winding_about_centroid(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                                          const BoxTree& tree, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace geomesh::geomodel::checking
