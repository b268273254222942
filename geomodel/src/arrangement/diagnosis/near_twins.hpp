// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Surfaces that were given twice, moved by next to nothing.
#pragma once

#include <utility>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel::arrangement {

/// Pairs of surfaces of which one follows the other: more than half of its vertices are within the distance of it,
/// and farther from it than rounding. No size can mesh what is between them. What coincides but for rounding is none of
/// these: the arrangement joins it. Pairs are asked whose boxes are that near, at some hundred vertices each. O(n log
/// n) by surface.
std::vector<std::pair<Index, Index>> near_twins(const std::vector<TriangulatedSurface>& surfaces, double distance);

}  // namespace geomesh::geomodel::arrangement
