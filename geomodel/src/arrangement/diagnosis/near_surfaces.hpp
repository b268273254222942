// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds surfaces that are duplicates up to a tiny movement, and surfaces that stop just short of others.
#pragma once

#include <utility>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel::arrangement {

/// Pairs of rows, the lesser first, ascending.
struct NearSurfaces {
  /// One follows the other: more than half of its vertices are within a distance of it, and farther from it than
  /// rounding. No size can mesh what is between them. What coincides but for rounding is none of these.
  std::vector<std::pair<Index, Index>> twins;
  /// One is a fault that ends beside the other: both ends of an edge with one triangle alone are within a distance of
  /// it. Borders of horizons that lie over each other are none of these.
  std::vector<std::pair<Index, Index>> ending;
};

/// Examines pairs whose boxes are that near: some hundred vertices each for duplicates, all borders for surfaces that
/// end. O(n log n) by surface.
NearSurfaces near_surfaces(const std::vector<TriangulatedSurface>& surfaces, double twin_distance, double end_distance);

}  // namespace geomesh::geomodel::arrangement
