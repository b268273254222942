// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Faces of second order against a surface.
#pragma once

#include <array>

#include "geomesh/core/geometry.hpp"

namespace geomesh {
class SurfaceDistance;
}

namespace geomesh::geomodel {

/// Place of the face at barycentric coordinates. Nodes: three corners, then the middles of edges 01 12 20.
Vec3 place_on_face(const std::array<Vec3, 6>& nodes, const std::array<double, 3>& at);

/// Whether all of the face is proven to be within the limit of the surface. It is cut into flat triangles with corners
/// on it. Let `bend` be the farthest that a node is from the middle of its straight edge. With n pieces an edge the
/// face is within 4 bend / (3 n^2) of them, as its Bezier form shows. For its difference from a flat piece is the sum
/// of 2 li lj eij. There eij is at most 2 bend / n^2, and the li lj add up to a third at most. The flat pieces are
/// proven within what is left of the limit. False where a place is farther, and where 16 pieces an edge do not tell.
bool is_face_within(const std::array<Vec3, 6>& nodes, const SurfaceDistance& surface, double limit);

}  // namespace geomesh::geomodel
