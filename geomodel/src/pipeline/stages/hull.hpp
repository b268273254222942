// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Adds the convex hull of all surfaces as a surface of its own (`--hull`), which is meshed like any other.
#pragma once

#include <vector>

#include "geomesh/core/run_context.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

inline constexpr const char* hull_name = "hull";

/// Returns the convex hull of all vertices of the surfaces, taken from their Delaunay tetrahedralization, with outward
/// normals. It is exact, because its vertices are input vertices. Throws the same errors as
/// delaunay_tetrahedralization.
TriangulatedSurface convex_hull_surface(const std::vector<TriangulatedSurface>& surfaces, const RunContext& context);

}  // namespace geomesh::geomodel
