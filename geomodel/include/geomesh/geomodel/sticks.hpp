// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Surfaces between lines that were interpreted down a fault (docs/input-formats.md).
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// A surface between the sticks of a fault.
struct SurfaceOfSticks {
  TriangulatedSurface surface;
  std::size_t n_sticks = 0;
  std::size_t n_gaps = 0;    ///< between neighbours that are farther apart than max_distance
  std::size_t n_folded = 0;  ///< triangles that are turned over: sticks cross, or double back
  Vec3 fold;                 ///< place of the first of them
};

/// Joins neighbouring lines by triangles, along the shorter diagonal each time; all points of the lines are vertices.
/// Lines may run either way and come in any order: they are put in order along the direction across them in which
/// their middles are spread most. `max_distance`: neighbours that come nowhere nearer are not joined; 0: all are.
/// Throws Error{invalid_input} where there are fewer than two lines of two points.
SurfaceOfSticks surface_of_sticks(const std::vector<Polyline>& lines, double max_distance);

/// "F1" of "F1__3", which readers call the third line of F1; other names as they are.
std::string name_without_part(const std::string& name);

}  // namespace geomesh::geomodel
