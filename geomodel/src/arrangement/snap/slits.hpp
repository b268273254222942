// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Places where a surface ends along an edge that another facet of it all but touches.
#pragma once

#include <cstdint>
#include <vector>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// A needle between two facets of a surface vanishes where its corners are on one line but for rounding. Its long edge
/// is then an end of the surface, and vertices that were on the other edges are beside it. Sets `active` of the facet
/// at such an edge and of the facets at those vertices that share a vertex with it. `distance`: of a vertex from the
/// edge. Facets are rows of `active`. O(n log n) where few facets are at a vertex.
void mark_slits(const Complex& complex, double distance, std::vector<std::uint8_t>& active);

}  // namespace geomesh::geomodel::arrangement
