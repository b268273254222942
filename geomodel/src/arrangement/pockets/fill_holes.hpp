// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Fills holes that arose in surfaces where several of them were merged.
#pragma once

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// If three surfaces meet within the distance, a facet of one of them that faces a facet of the two others may vanish.
/// A surface that ends at all three edges of a facet lower than twice the distance gets that facet too. So does one
/// that ends at its two long edges, if the third edge is no longer than twice the distance, and shorter than an eighth
/// of both together. Returns how many facets were given. Nothing moves. O(n log n).
std::size_t fill_holes(Complex& complex, double distance);

}  // namespace geomesh::geomodel::arrangement
