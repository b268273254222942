// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds surfaces that are duplicates up to a tiny movement, and surfaces that stop just short of others.
#pragma once

#include <utility>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel::arrangement {

/// Pairs of surfaces by their indices, the smaller first, in ascending order.
struct NearSurfaces {
  /// Pairs of surfaces that are nearly duplicates: more than half of one's vertices are within a distance of the other,
  /// but farther from it than rounding explains. No mesh of the target size can resolve the gap between them. Surfaces
  /// that coincide up to rounding are not included.
  std::vector<std::pair<Index, Index>> duplicates;
  /// Pairs in which a fault ends just beside the other surface: both ends of one of its border edges are within a
  /// distance of that surface. Borders of horizons that lie above each other are not included.
  std::vector<std::pair<Index, Index>> ending;
};

/// Examines pairs of surfaces whose bounding boxes are within the two distances: some hundred vertices each to find
/// duplicates, all border edges to find surfaces that end. O(n log n) per surface.
NearSurfaces near_surfaces(const std::vector<TriangulatedSurface>& surfaces, double duplicate_distance,
                           double end_distance);

}  // namespace geomesh::geomodel::arrangement
