// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What lies on sides of the volume, or passes edges between them, but for rounding or for a tolerance. Hardly any
/// double lies on a side of a turned box or of a polygon of the map. What was given on it is beside it by rounding.
#pragma once

#include <optional>

#include "arrangement/join/join_surfaces.hpp"

namespace geomesh::geomodel::arrangement {

/// Surfaces are joined to sides that are no planes of a box wherever they are nearer than `joining.distance`, some
/// ulps. Rows of a grid that lie along a side would wind through it else, and leave needles an ulp wide. Sides are
/// split at vertices of surfaces, and leave their planes by no more than that. What crosses a side plainly is left to
/// the exact intersection. So is what lies on sides exactly, where all does. `vertex_now` as snap_near() gives it.
/// Nothing where sides are planes of a box, or where nothing is near enough. O(n log s) for n facets and s facets of
/// sides, where each facet's box meets few of these.
std::optional<SnapOutcome> join_to_sides(Complex& complex, const Joining& joining,
                                         std::vector<VertexIndex>& vertex_now);

/// Vertices within reach of a corner of the volume move to it, otherwise to an edge between two sides, otherwise to a
/// side (Reach). They do so from either side of it, apart from rounding. Ends of an edge of a surface that is as near
/// to a side's plane move to it, even if they are beyond the volume. join_to_sides() does the rest. Movements that
/// would turn a triangle over are left out. Cost as above.
Displacement move_to_sides(Complex& complex, const Joining& joining, double tolerance);

/// Facets that run along an edge between two sides within reach are drawn to it. They are split at its ends, where
/// these are as near, and where their own edges pass it. Such facets would part from the edge at so small an angle that
/// no element fits between. The edges of sides keep their places, but for rounding. Nothing where all that is near lies
/// on these edges exactly. Vertices that are near are to be on them: move_to_sides() comes first. O(n log c) for n
/// facets and c such edges, where each facet's box meets few of these.
std::optional<SnapOutcome> draw_to_creases(Complex& complex, const Joining& joining, double tolerance);

/// For SnapOptions::sides_of, of a volume that is no box along the axes; else empty. O(n log s).
std::vector<std::uint64_t> sides_of_vertices(const Complex& complex, const Joining& joining);

}  // namespace geomesh::geomodel::arrangement
