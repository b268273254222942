// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Measures the distance of second-order faces from a surface.
#pragma once

#include <array>

#include "geomesh/core/geometry.hpp"

namespace geomesh {
class SurfaceDistance;
}

namespace geomesh::geomodel {

/// Returns the point of a second-order face at barycentric coordinates. Its nodes are three corners, then the midpoints
/// of the edges 01 12 20.
Vec3 place_on_face(const std::array<Vec3, 6>& nodes, const std::array<double, 3>& at);

/// Returns whether a second-order face is proven to lie completely within the limit of the surface. The face is
/// approximated by flat triangles with corners on it. Let `bend` be the largest distance of a midpoint node from the
/// middle of its straight edge. With n pieces per edge, the face is within 4 bend / (3 n^2) of the triangles: in Bezier
/// form, its difference from a flat triangle is the sum of 2 li lj eij, in which eij is at most 2 bend / n^2 and the li
/// lj add up to at most a third. The flat triangles are then proven to be within the rest of the limit. Returns false
/// if a point of the face is farther away, or if 16 pieces per edge do not decide.
bool is_face_within(const std::array<Vec3, 6>& nodes, const SurfaceDistance& surface, double limit);

}  // namespace geomesh::geomodel
