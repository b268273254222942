// SPDX-License-Identifier: MIT
/// @file
/// The shear that makes a model's facets level. A tilted thin plate looks thick along every axis, so that no scaling of
/// an axis brings its segments into the Delaunay triangulation. If a shear makes it level, scaling an axis does.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "recover/model/constraints.hpp"

namespace geomesh::recover {

/// Returns the points, sheared along an axis so that the plane of the largest facet is parallel to the other two axes.
/// Returns nothing if the plane already is parallel to them, if most of the facets' area is not parallel to it, or if a
/// sum would be rounded. The shear is therefore exact: orientations are the same as before, and a triangulation of the
/// sheared points is one of the given points. O(n).
std::optional<std::vector<Vec3>> with_level_facets(const std::vector<Vec3>& points, const Constraints& constraints);

/// Returns the axis along which with_level_facets() shears a plane through three points that are not collinear, in a
/// model of these extents. If no shear makes the plane level, returns the axis nearest to its normal. If two axes are
/// equally near, it is the one along which the model extends farther, because that gives the same result for every
/// facet and in every frame: roofs (plc/roof.hpp) are Delaunay in projection along this axis before the model is
/// started from its level frame.
std::size_t level_axis(const std::array<Vec3, 3>& corners, const Vec3& extents);

}  // namespace geomesh::recover
