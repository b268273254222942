// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Rules that apply to a single surface before the arrangement: filling holes, extending, closing open bodies.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"

namespace geomesh::geomodel {

/// Steeper slopes are extended horizontally, because a sheet that folds over there has no single height.
inline constexpr double steepest_slope = 3;

/// Receives notes and warnings. Each rule appends points and triangles to the surface (given rows do not change) and
/// reports what it did or why it could not.
struct BuildLog {
  std::vector<std::string>& notes;
  std::vector<std::string>& warnings;
};

/// Fills holes whose border is at most `longest_border` long with the Delaunay triangulation of their border, computed
/// in the map, or in the mean plane for faults and bodies.
void fill_holes(TriangulatedSurface& surface, double longest_border, const BuildLog& log);

/// Extends the surface from its outer border to beyond the box, in the frame of fill_holes. The areas between sheets of
/// one surface (a horizon given block by block) are filled as well. Holes are kept. Returns false, with a warning, if
/// the border crosses itself in the frame; the surface is then unchanged.
bool extend_to_box(TriangulatedSurface& surface, Extend how, const Box3& box, const BuildLog& log);

/// Closes every border loop of a body: a loop that reaches into the box is first extruded beyond the box's nearest
/// side.
void close_body(TriangulatedSurface& surface, const Box3& box, const BuildLog& log);

}  // namespace geomesh::geomodel
