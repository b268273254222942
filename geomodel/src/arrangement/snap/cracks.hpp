// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds cracks: places where a surface ends along an edge that another of its facets almost touches.
#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// A needle between two facets of a surface vanishes if its corners are collinear up to rounding. Its long edge is then
/// an end of the surface, and vertices of the other edges are beside it (a crack). Sets `active` for the facet at such
/// an edge and for the facets at those vertices that share a vertex with it. `distance` is that of a vertex from the
/// edge. Facets are rows of `active`. O(n log n) if few facets are at a vertex.
void mark_cracks(const Complex& complex, double distance, std::vector<std::uint8_t>& active);

}  // namespace geomesh::geomodel::arrangement
