// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How triangles meet and how a surface winds about a point, decided exactly.
#pragma once

#include <optional>
#include <vector>

#include "check/exact/box_tree.hpp"
#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel::checking {

enum class Meeting {
  proper,    ///< apart, or in shared vertices and edges only
  overlap,   ///< coplanar, and an area or a stretch of edge in common
  crossing,  ///< any other point in common
};
/// Triangles with any points, told apart by index. Triangles of zero area are `proper` with everything.
Meeting meeting(const std::vector<Vec3>& points, const Triangle& s, const Triangle& t);

/// Winding number, of the closed oriented surface `triangles`, just outside face f of it (on the side that its normal
/// points to). `tree` is over the triangles' boxes. Expects an embedded surface.
int winding_outside(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, Index f,
                    const BoxTree& tree);

/// Winding number of the closed oriented surface about the centroid of a, b, c; nothing where the centroid is on the
/// surface.
std::optional<int> winding_about_centroid(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
                                          const BoxTree& tree, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace geomesh::geomodel::checking
