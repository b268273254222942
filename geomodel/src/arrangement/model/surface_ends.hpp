// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds edges at which surfaces of a complex end.
#pragma once

#include <vector>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// An edge at which a surface has exactly one facet, so that it ends there.
struct SurfaceEnd {
  VertexIndex a, b;  ///< a < b
  Index surface, facet;
};

/// Returns the edges at which surfaces end, in ascending order by edge, then by surface. O(n log n).
std::vector<SurfaceEnd> surface_ends(const Complex& complex);

/// Returns the surfaces with an edge that has three or more of their facets, ascending. O(n log n).
std::vector<Index> branching_surfaces(const Complex& complex);

}  // namespace geomesh::geomodel::arrangement
