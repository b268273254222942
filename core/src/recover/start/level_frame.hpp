// SPDX-License-Identifier: MIT
/// @file
/// The shear that makes a model's facets level. A thin plate that is tilted looks thick along every axis, so no
/// scale of an axis brings its segments into the Delaunay triangulation; once it is level, one does.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "recover/model/constraints.hpp"

namespace geomesh::recover {

/// The points, sheared along an axis so that the plane of the largest facet runs along the other two axes. Returns
/// nothing where it does so already, where most of all facets' area is not parallel to it, and where a sum would be
/// rounded. So the shear is exact: orientations are the same as before, and a triangulation of the sheared points is
/// one of the given points. O(n).
std::optional<std::vector<Vec3>> with_level_facets(const std::vector<Vec3>& points, const Constraints& constraints);

/// The axis of that shear for a plane through three points that are not on one line, in a model of these extents; the
/// axis nearest to the plane's normal if none makes it level. Where two axes are equally near, it is the one along
/// which the model extends farther, because that says the same of every facet and in every frame: roofs (plc/roof.hpp)
/// are Delaunay as seen along this axis before the model is started from its level frame.
std::size_t level_axis(const std::array<Vec3, 3>& corners, const Vec3& extents);

}  // namespace geomesh::recover
