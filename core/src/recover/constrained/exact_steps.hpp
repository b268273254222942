// SPDX-License-Identifier: MIT
/// @file
/// Steiner points at exact places (exact_points.hpp). Each point removes at least one crossing, and a suitable place
/// always exists: at the crossing itself all cells of the new star are strictly positive, and therefore also at places
/// sufficiently near the crossing.
#pragma once

#include "recover/model/recover.hpp"

namespace geomesh::recover {

/// Adds a point on a missing subsegment where the line crosses the mesh: as far from other vertices as possible, or at
/// the first crossing. Returns no_vertex if coordinates would exceed ExactPlace::is_safe.
VertexIndex step_along_segment(Recovery& recovery, Index subsegment);

/// Adds a point in the plane of three vertices where the edge below-above crosses the plane. Returns no_vertex if
/// nothing has changed, as step_along_segment does.
VertexIndex step_onto_plane(Recovery& recovery, const Triangle& plane, VertexIndex below, VertexIndex above);

}  // namespace geomesh::recover
