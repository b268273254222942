// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Estimates how often the fractures of a network cross each other.
#pragma once

#include <vector>

#include "geomesh/geomodel/refinement.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

struct NetworkCrossings {
  double lines = 0;   ///< number of pairs of fractures that cross inside the box of the model
  double points = 0;  ///< number of points inside the box of the model in which three fractures meet
};

/// Estimates how many pairs of fractures cross and how many points three fractures share. At most 200 of the fractures,
/// and at most 200 of the lines in which they cross others, are compared with all fractures, in O(fractures). If there
/// are no more, the numbers are exact, provided that the fractures are convex. Precondition: they are plane polygons.
NetworkCrossings estimate_crossings(const std::vector<const TriangulatedSurface*>& fractures, const Box3& bounds);

/// Throws Error{cannot_mesh} if the crossings of fractures require more elements than settings.max_elements. Many
/// planes divide space into as many cells as there are points in which three planes meet, and each cell takes at least
/// five tetrahedra on average.
void require_countable(const NetworkCrossings& crossings, std::size_t n_fractures, const RefinementSettings& settings);

}  // namespace geomesh::geomodel
