// SPDX-License-Identifier: MIT
/// @file
/// Steiner points at exact places (exact_points.hpp). Each point removes at least one crossing, and a suitable place
/// always exists: at the crossing itself all cells of the new star are strictly positive, and therefore also at places
/// sufficiently near the crossing.
#pragma once

#include "recover/model/recover.hpp"

namespace geomesh::recover {

/// Adds a point on a missing subsegment where it crosses a mesh face or edge: the crossing farthest from other
/// vertices, or the first one. Returns no_vertex if the point's exact coordinates would need too many digits.
VertexIndex step_along_segment(Recovery& recovery, Index subsegment);

/// Adds a point in the plane of three vertices where the edge below-above crosses the plane. Returns no_vertex, and
/// changes nothing, if the point's exact coordinates would need too many digits.
VertexIndex step_onto_plane(Recovery& recovery, const Triangle& plane, VertexIndex below, VertexIndex above);

}  // namespace geomesh::recover
