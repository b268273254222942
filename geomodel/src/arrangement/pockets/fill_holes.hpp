// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Fills holes that arose in surfaces where several of them were merged.
#pragma once

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// Fills holes that merging left in surfaces, by assigning the surfaces to existing facets. If three surfaces meet
/// within the distance, a facet of one of them that faces a facet of the two others may vanish. A surface that ends at
/// all three edges of a facet lower than twice the distance is assigned that facet too. The same applies to a surface
/// that ends at the facet's two long edges, if the third edge is no longer than twice the distance, and shorter than an
/// eighth of the sum of both. Returns the number of assigned facets. Nothing moves. O(n log n).
std::size_t fill_holes(Complex& complex, double distance);

}  // namespace geomesh::geomodel::arrangement
