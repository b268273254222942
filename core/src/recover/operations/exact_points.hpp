// SPDX-License-Identifier: MIT
/// @file
/// Computes places that lie exactly on a segment or in a facet's plane, near a given place. They can be arbitrarily
/// near: in exact arithmetic, what holds strictly at a crossing also holds at some dyadic parameter near it.
#pragma once

#include "recover/model/constrained_mesh.hpp"

namespace geomesh::recover {

/// Returns the parameter, from 0 at a to 1 at b, at which the line a-b meets the plane of three vertices, up to
/// `error`. The ends must not both lie in that plane.
exact::LongExpansion crossing_parameter(const ConstrainedMesh& mesh, VertexIndex a, VertexIndex b,
                                        const Triangle& plane, double error);

/// Returns the place on the line through a and b at parameter t, up to `error`. If a and b are exact places on another
/// line, the result lies exactly on that line.
ExactPlace place_on_line(const ConstrainedMesh& mesh, VertexIndex a, VertexIndex b, const exact::LongExpansion& t,
                         double error);

/// Returns the place at which the line through the vertices `below` and `above` meets the plane of three others, up to
/// `error`. The place lies exactly in that plane.
ExactPlace place_in_plane(const ConstrainedMesh& mesh, const Triangle& plane, VertexIndex below, VertexIndex above,
                          double error);

/// Returns the exact place of vertex x after a move along the line (by step.x) or in the plane (by step.x and step.y)
/// on which it was placed, or in any direction if there is none.
ExactPlace place_moved(const ConstrainedMesh& mesh, VertexIndex x, const Vec3& step);
/// Returns the exact place of vertex x after a move in any direction, off the line or plane on which it was placed.
ExactPlace place_beside(const ConstrainedMesh& mesh, VertexIndex x, const Vec3& step);

}  // namespace geomesh::recover
