// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Rules that apply to a single surface before the arrangement: filling its holes, extending it, closing an open body.
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"

namespace geomesh::geomodel {

/// Largest slope that is extrapolated. Steeper slopes continue horizontally, lest the surface folds over.
inline constexpr double steepest_slope = 3;

/// Receives the notes and warnings of the rules that extend surfaces. A rule appends points and triangles to a surface,
/// without changing existing ones, and reports what it did or why it could not.
struct BuildLog {
  std::vector<std::string>& notes;
  std::vector<std::string>& warnings;
};

/// Fills holes whose border is at most `longest_border` long with the Delaunay triangulation of their border, computed
/// in the map, or in the mean plane for faults and bodies.
void fill_holes(TriangulatedSurface& surface, double longest_border, const BuildLog& log);

/// Options for the points that an extension has in addition to those of the border.
struct ContinuationPoints {
  /// Number that distinguishes extensions over the same area: with different numbers, they share no outer border edge.
  Index rim = 0;
  /// Whether points are placed on a grid beyond the surface's border; if not, straight lines bridge the area to the
  /// outer border.
  bool inside = true;
};

/// Extends the surface from its outer border to beyond the box, in the map, or in the mean plane for faults and bodies.
/// The areas between connected parts of one surface (a horizon given block by block) are filled as well. Holes are
/// kept. Returns false, with a warning, if the border crosses itself in that plane; the surface is then unchanged.
bool extend_to_box(TriangulatedSurface& surface, Extend how, const Box3& box, const BuildLog& log,
                   const ContinuationPoints& added = {});

/// Closes every border loop of a body. A loop that reaches into the box is first extruded beyond the box's nearest
/// side.
void close_body(TriangulatedSurface& surface, const Box3& box, const BuildLog& log);

}  // namespace geomesh::geomodel
