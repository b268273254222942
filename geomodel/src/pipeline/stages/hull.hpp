// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `--hull`: adds the convex hull of all surfaces as a surface of its own, so that it is intersected, named and
/// verified like any other.
#pragma once

#include <vector>

#include "geomesh/core/run_context.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

inline constexpr const char* hull_name = "hull";

/// Returns the hull faces of the Delaunay tetrahedralization of all vertices, with normals outward. Exact, because its
/// vertices are input vertices. Throws as delaunay_tetrahedralization does.
TriangulatedSurface convex_hull_surface(const std::vector<TriangulatedSurface>& surfaces, const RunContext& context);

}  // namespace geomesh::geomodel
