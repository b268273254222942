// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Edges at which surfaces of a complex end.
#pragma once

#include <vector>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// An edge at which one facet of a surface is.
struct SurfaceEnd {
  VertexIndex a, b;  ///< a < b
  Index surface, facet;
};

/// Ascending by edge, then by surface. O(n log n).
std::vector<SurfaceEnd> surface_ends(const Complex& complex);

/// Surfaces with an edge at which three facets of theirs or more are, ascending. O(n log n).
std::vector<Index> branching_surfaces(const Complex& complex);

}  // namespace geomesh::geomodel::arrangement
