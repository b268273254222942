// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Surfaces interpolated between sticks, the lines interpreted down the dip of a fault (docs/input-formats.md).
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// A surface made from the sticks of a fault.
struct SurfaceOfSticks {
  TriangulatedSurface surface;
  std::size_t n_sticks = 0;
  std::size_t n_gaps = 0;    ///< number of neighbouring sticks farther apart than max_distance
  std::size_t n_folded = 0;  ///< number of inverted triangles, which arise if sticks cross or double back
  Vec3 fold;                 ///< place of the first inverted triangle
};

/// Joins neighbouring lines by triangles, along the shorter diagonal each time; all points of the lines are vertices.
/// Lines may run either way and come in any order: they are put in order along the direction across them in which their
/// middles are spread most. `max_distance`: neighbours that are nowhere closer than this are not joined; 0: all are.
/// Throws Error{invalid_input} where there are fewer than two lines of two points.
SurfaceOfSticks surface_of_sticks(const std::vector<Polyline>& lines, double max_distance);

/// Returns "F1" for "F1__3", the name that readers give to the third line of F1; other names are returned unchanged.
std::string name_without_part(const std::string& name);

}  // namespace geomesh::geomodel
