// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `--hull`: the convex hull of all surfaces as a surface of its own, so that it is intersected, named and verified as
/// any other.
#pragma once

#include <vector>

#include "geomesh/core/run_context.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

inline constexpr const char* hull_name = "hull";

/// The hull faces of the Delaunay tetrahedralization of all vertices, normals outward. Exact: its vertices are input
/// vertices. Throws as delaunay_tetrahedralization does.
TriangulatedSurface convex_hull_surface(const std::vector<TriangulatedSurface>& surfaces, const RunContext& context);

}  // namespace geomesh::geomodel
