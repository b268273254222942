// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Sides of a volume that is no box along the axes: of a turned box, of a polygon of the map. Hardly any double lies on
/// such a plane, so what was given on it is beside it by rounding.
#pragma once

#include <optional>

#include "arrangement/snap/join_surfaces.hpp"

namespace geomesh::geomodel::arrangement {

/// Surfaces are joined to such sides wherever they are nearer than `joining.distance`, some ulps. Rows of a grid that
/// lie along a side would wind through it else, and leave needles an ulp wide. Sides are split at vertices of surfaces,
/// and leave their planes by no more than that. What lies on a side exactly is left to the exact intersection, and so
/// is what crosses it plainly. `vertex_now` as snap_near() gives it. Nothing where sides are planes of a box, or where
/// nothing is near enough. O(n log s) for n facets and s facets of sides, where each facet's box meets few of these.
std::optional<SnapOutcome> join_to_sides(Complex& complex, const Joining& joining,
                                         std::vector<VertexIndex>& vertex_now);

/// Ends of surfaces nearer than `tolerance` to such a side, on either side of it, go to it, but for rounding: to a
/// corner of the volume that is as near, else to an edge between two sides, else to the side. Ends of an edge that
/// follows a side go to its plane, also where they are beyond the volume. Other vertices go from nearer than a
/// hundredth of the tolerance. join_to_sides() does the rest. What would turn a triangle over stays. Cost as above.
Displacement move_to_sides(Complex& complex, const Joining& joining, double tolerance);

}  // namespace geomesh::geomodel::arrangement
