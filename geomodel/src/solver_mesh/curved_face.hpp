// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Measures faces of second order against a surface.
#pragma once

#include <array>

#include "geomesh/core/geometry.hpp"

namespace geomesh {
class SurfaceDistance;
}

namespace geomesh::geomodel {

/// Returns the place of the face at barycentric coordinates. Nodes: three corners, then the midpoints of edges 01 12
/// 20.
Vec3 place_on_face(const std::array<Vec3, 6>& nodes, const std::array<double, 3>& at);

/// Returns whether all of the face is proven to be within the limit of the surface. It is approximated by flat
/// triangles with corners on it. Let `bend` be the largest distance of a node from the midpoint of its straight edge.
/// With n pieces per edge the face is within 4 bend / (3 n^2) of them, as its Bezier form shows. For its difference
/// from a flat piece is the sum of 2 li lj eij. There eij is at most 2 bend / n^2, and the li lj add up to a third at
/// most. The flat pieces are then proven to be within the rest of the limit. Returns false if a place is farther, or if
/// 16 pieces per edge do not decide.
bool is_face_within(const std::array<Vec3, 6>& nodes, const SurfaceDistance& surface, double limit);

}  // namespace geomesh::geomodel
