// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds cracks: places where a surface ends along an edge that another of its facets almost touches.
#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// Marks the facets at cracks in `active`. A crack arises if a needle between two facets of a surface vanishes because
/// its corners are collinear up to rounding: the surface then ends at the needle's long edge, and vertices of the other
/// edges lie beside it. Marked are the facet at such an edge, and the facets at those vertices that share a vertex with
/// it. `distance` is the largest one of a vertex from the edge. O(n log n) if few facets are at a vertex.
void mark_cracks(const Complex& complex, double distance, std::vector<std::uint8_t>& active);

}  // namespace geomesh::geomodel::arrangement
