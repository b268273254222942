// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Moves surfaces that lie on sides of the volume, or beside edges between them, onto these, up to rounding or a
/// tolerance. Hardly any double lies on a side of a turned box or of a polygon of the map, so points that were given on
/// it are beside it by rounding.
#pragma once

#include <optional>

#include "arrangement/join/join_surfaces.hpp"

namespace geomesh::geomodel::arrangement {

/// Merges surfaces with sides that are no planes of a box wherever they are nearer than `joining.distance`, some ulps.
/// Rows of a grid along a side would otherwise wind through it, and leave needles an ulp wide. Sides are split at
/// vertices of surfaces, and leave their planes by no more than that. Surfaces that cross a side plainly are left to
/// the exact intersection, as are those exactly on sides, if all are. `vertex_now` is as from snap_near(). Returns
/// nothing if sides are planes of a box, or if nothing is near enough. O(n log s) for n facets and s facets of sides,
/// if each facet's box meets few of these.
std::optional<SnapOutcome> join_to_sides(Complex& complex, const Joining& joining,
                                         std::vector<VertexIndex>& vertex_now);

/// Vertices within reach of a corner of the volume move to it, otherwise to an edge between two sides, otherwise to a
/// side (Reach). They do so from either side of it, apart from rounding. Ends of a surface's edge that is as close to a
/// side's plane move to it, even if they are beyond the volume. join_to_sides() does the rest. Movements that would
/// invert a triangle are left out. Cost as above.
Displacement move_to_sides(Complex& complex, const Joining& joining, double tolerance);

/// Moves facets that run along an edge between two sides within reach onto it. They are split at its ends, if these are
/// as near, and where their own edges pass it. Otherwise such facets would leave the edge at so small an angle that no
/// element fits between. The edges of sides keep their places up to rounding. Returns nothing if everything near lies
/// on these edges exactly. Vertices that are near must be on them already: move_to_sides() comes first. O(n log c) for
/// n facets and c such edges, if each facet's box meets few of these.
std::optional<SnapOutcome> draw_to_feature_edges(Complex& complex, const Joining& joining, double tolerance);

/// Returns the bits for SnapOptions::sides_of for a volume that is not a box along the axes; otherwise empty. O(n log
/// s).
std::vector<std::uint64_t> sides_of_vertices(const Complex& complex, const Joining& joining);

}  // namespace geomesh::geomodel::arrangement
