// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Moves surfaces that lie on sides of the volume, or beside edges between two sides, onto these, up to rounding or a
/// tolerance. Hardly any double lies exactly on a side of a rotated box or of a polygon in the map, so points that were
/// meant to be on such a side are beside it by rounding.
#pragma once

#include <optional>

#include "arrangement/join/join_surfaces.hpp"

namespace geomesh::geomodel::arrangement {

/// Merges surfaces with sides of the volume wherever they are closer than `joining.distance`, some ulps; not with sides
/// in planes of a box. Without this, grid lines along a side would wind through it and leave needles an ulp wide. Sides
/// are split at vertices of surfaces, and leave their planes by no more than the distance. Surfaces that cross a side
/// plainly are left to the exact intersection, as is everything if all near surfaces lie exactly on sides. `vertex_now`
/// is as for snap_near(). Returns nothing if sides are planes of a box, or if nothing is near enough. O(n log s) for n
/// facets and s facets of sides, if each facet's box meets few of the latter.
std::optional<SnapOutcome> join_to_sides(Complex& complex, const Joining& joining,
                                         std::vector<VertexIndex>& vertex_now);

/// Moves vertices that are within reach (class Reach) of a corner of the volume to it, otherwise to an edge between two
/// sides, otherwise to a side. Vertices may come from inside or outside the volume. Ends of a surface's edge that is
/// within reach of a side's plane move to that plane, even if they are beyond the volume. Distances within rounding are
/// left to join_to_sides(). Movements that would invert a triangle are left out. Cost as for join_to_sides().
Displacement move_to_sides(Complex& complex, const Joining& joining, double tolerance);

/// Moves facets that run along an edge between two sides, within reach of it, onto that edge. Otherwise they would
/// leave the edge at so small an angle that no element fits between. The facets are split at the ends of the edge, if
/// these are within reach, and where facet edges pass it. The edges of sides keep their places up to rounding. Returns
/// nothing if everything near lies exactly on these edges. Precondition: move_to_sides() has moved vertices onto these
/// edges. O(n log c) for n facets and c such edges, if each facet's box meets few of these.
std::optional<SnapOutcome> draw_to_feature_edges(Complex& complex, const Joining& joining, double tolerance);

/// Returns, as bits, the sides of the volume on which each vertex lies; empty for an axis-aligned box. O(n log s).
std::vector<std::uint64_t> sides_of_vertices(const Complex& complex, const Joining& joining);

}  // namespace geomesh::geomodel::arrangement
