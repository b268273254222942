// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Rules on one surface before the arrangement: holes, continuation, open bodies.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"

namespace geomesh::geomodel {

/// Steeper slopes are continued level: a sheet that is folded over there has no one height.
inline constexpr double steepest_slope = 3;

/// Each appends points and triangles to the surface (rows as given stay), and says what it did or why it could not.
struct BuildLog {
  std::vector<std::string>& notes;
  std::vector<std::string>& warnings;
};

/// Fills holes whose border is at most `longest_border` long with the Delaunay triangulation of their border. It is
/// made in the map, for faults and bodies in the mean plane.
void fill_holes(TriangulatedSurface& surface, double longest_border, const BuildLog& log);

/// Continues the surface from its outer border to beyond the box, in the frame of fill_holes. What lies between sheets
/// of one surface (a horizon given block by block) is filled as well. Holes stay. False where its border crosses itself
/// in the frame, which a warning tells: the surface stays as it is.
bool extend_to_box(TriangulatedSurface& surface, Extend how, const Box3& box, const BuildLog& log);

/// Closes every border loop of a body: a loop that reaches into the box is first drawn out beyond the box's nearest
/// side.
void close_body(TriangulatedSurface& surface, const Box3& box, const BuildLog& log);

}  // namespace geomesh::geomodel
