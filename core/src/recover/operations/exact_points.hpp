// SPDX-License-Identifier: MIT
/// @file
/// Places that lie exactly on a segment or in a facet's plane, near a place that is wanted. As near as is asked for:
/// in exact arithmetic what holds at a crossing strictly holds at some dyadic parameter near it.
#pragma once

#include "recover/model/constrained_mesh.hpp"

namespace geomesh::recover {

/// From a (0) to b (1): where the line through them meets the plane of p, q, r. Both ends are not in that plane alike.
exact::LongExpansion crossing_parameter(const ConstrainedMesh& mesh, VertexIndex a, VertexIndex b,
                                        const Triangle& plane, double error);

/// On the line through a and b, at parameter t but for `error`; on the line that a and b lie on themselves where they
/// are exact places of one.
ExactPlace place_on_line(const ConstrainedMesh& mesh, VertexIndex a, VertexIndex b, const exact::LongExpansion& t,
                         double error);

/// In the plane of three vertices, where the line through below and above meets it but for `error`.
ExactPlace place_in_plane(const ConstrainedMesh& mesh, const Triangle& plane, VertexIndex below, VertexIndex above,
                          double error);

/// The place of x moved by a step along its line (step.x), in its plane (step.x, step.y along the frame's sides), or
/// freely. x is exact.
ExactPlace place_moved(const ConstrainedMesh& mesh, VertexIndex x, const Vec3& step);
/// Off line and plane.
ExactPlace place_beside(const ConstrainedMesh& mesh, VertexIndex x, const Vec3& step);

}  // namespace geomesh::recover
