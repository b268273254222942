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

/// Expected numbers from at most 200 fractures and at most 200 of the lines in them, each held against all fractures:
/// O(fractures). Exact for fewer than 200 convex fractures with fewer than 200 lines. Precondition: the surfaces are
/// plane polygons.
NetworkCrossings estimate_crossings(const std::vector<const TriangulatedSurface*>& fractures, const Box3& bounds);

/// Throws Error{cannot_mesh} where crossings alone bring more elements than settings.max_elements. The cells that many
/// planes divide space into are as many as the points where three meet, and each takes five tetrahedra or more.
void require_countable(const NetworkCrossings& crossings, std::size_t n_fractures, const RefinementSettings& settings);

}  // namespace geomesh::geomodel
