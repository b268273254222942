// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds surfaces that are duplicates up to a tiny movement, and surfaces that stop just short of others.
#pragma once

#include <utility>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel::arrangement {

/// Pairs of rows, the smaller first, ascending.
struct NearSurfaces {
  /// Pairs of which one follows the other: more than half of its vertices are within a distance of it, and farther from
  /// it than rounding. No mesh of the target size can resolve the gap between them. Surfaces that coincide up to
  /// rounding are not included.
  std::vector<std::pair<Index, Index>> duplicates;
  /// Pairs of which one is a fault that ends beside the other: both ends of an edge with one triangle are within a
  /// distance of it. Borders of horizons that lie above each other are not included.
  std::vector<std::pair<Index, Index>> ending;
};

/// Examines pairs whose boxes are that close: some hundred vertices each for duplicates, all borders for surfaces that
/// end. O(n log n) per surface.
NearSurfaces near_surfaces(const std::vector<TriangulatedSurface>& surfaces, double duplicate_distance,
                           double end_distance);

}  // namespace geomesh::geomodel::arrangement
