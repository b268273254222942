// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How often the fractures of a network cross each other.
#pragma once

#include <vector>

#include "geomesh/geomodel/refinement.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

struct NetworkCrossings {
  double lines = 0;   ///< pairs of fractures that cross each other in the bounds
  double points = 0;  ///< three fractures that meet in a point there
};

/// Estimated numbers. Of all fractures at most 200, and of the lines in these at most 200, are held against all
/// fractures, in O(fractures). If there are no more, the numbers are exact, provided that the fractures are convex.
/// Precondition: the surfaces are plane polygons.
NetworkCrossings estimate_crossings(const std::vector<const TriangulatedSurface*>& fractures, const Box3& bounds);

/// Throws Error{cannot_mesh} where crossings alone bring more elements than settings.max_elements. The cells that many
/// planes divide space into are as many as the points where three meet, and take five tetrahedra or more on average.
void require_countable(const NetworkCrossings& crossings, std::size_t n_fractures, const RefinementSettings& settings);

}  // namespace geomesh::geomodel
