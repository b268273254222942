// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines whether triangles reach farther than a limit from a set of edges.
#pragma once

#include <array>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

using EdgeEnds = std::array<Vec3, 2>;

/// Returns whether the triangle reaches farther than `limit` from all of the edges. False means that every point of the
/// triangle is proven to be within `limit` of one edge. This does not follow from the corners alone: the triangle is
/// subdivided until each part is proven to be near, or a place is found that is not. Returns true if 64 subdivisions of
/// a side do not decide. Cost: few parts, except for triangles that reach almost exactly to the limit.
bool reaches_beyond(const std::array<Vec3, 3>& triangle, const std::vector<EdgeEnds>& edges, double limit);

}  // namespace geomesh::geomodel
