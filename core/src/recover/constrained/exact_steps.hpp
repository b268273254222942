// SPDX-License-Identifier: MIT
/// @file
/// Steiner points at exact places (exact_points.hpp). Each takes at least one crossing away, and there is always such a
/// place: at the crossing itself all cells of the new star are strictly positive, so near enough to it they are too.
#pragma once

#include "recover/model/recover.hpp"

namespace geomesh::recover {

/// Puts a point on a missing subsegment where the line crosses the mesh: as far from other vertices as can be, and
/// where that does not go at the first crossing. no_vertex: nothing has changed, which takes coordinates beyond
/// ExactPlace::is_safe.
VertexIndex step_along_segment(Recovery& recovery, Index subsegment);

/// Puts a point in the plane of three vertices where edge below-above pierces it. no_vertex: as above.
VertexIndex step_onto_plane(Recovery& recovery, const Triangle& plane, VertexIndex below, VertexIndex above);

}  // namespace geomesh::recover
