// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How far triangles reach from edges.
#pragma once

#include <array>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

using EdgeEnds = std::array<Vec3, 2>;

/// False where every point of the triangle is shown to be within `limit` of one of the edges. What lies between cannot
/// be told from its corners: it is cut into parts until each is shown to be near, or a place is found that is not.
/// Where 64 cuts of a side leave it open, it is true. Cost: few parts, but for triangles that reach just so far.
bool reaches_beyond(const std::array<Vec3, 3>& triangle, const std::vector<EdgeEnds>& edges, double limit);

}  // namespace geomesh::geomodel
