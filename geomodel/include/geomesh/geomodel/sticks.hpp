// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Fault surfaces interpolated between sticks, which are lines interpreted down the dip of a fault
/// (docs/input-formats.md).
#pragma once

#include <string>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// A surface made from the sticks of a fault.
struct SurfaceOfSticks {
  TriangulatedSurface surface;
  std::size_t n_sticks = 0;
  std::size_t n_gaps = 0;    ///< number of pairs of neighbouring sticks farther apart than max_distance
  std::size_t n_folded = 0;  ///< number of inverted triangles, which arise if sticks cross or double back
  Vec3 fold;                 ///< a point on the first inverted triangle, where sticks of the fault cross or double back
};

/// Interpolates a fault surface between sticks. Neighbouring sticks are joined by triangles, each time along the
/// shorter diagonal; all points of the sticks are vertices. Sticks may run either way and come in any order: they are
/// sorted along the direction in which their midpoints are most spread. Neighbours that are nowhere closer than
/// `max_distance` are not joined; 0: all are. Throws Error{invalid_input} if there are fewer than two sticks of two
/// points.
SurfaceOfSticks surface_of_sticks(const std::vector<Polyline>& lines, double max_distance);

/// Returns the name of a line without the number that readers append: "F1" for "F1__3", the third line of F1. Other
/// names are returned unchanged.
std::string name_without_part(const std::string& name);

}  // namespace geomesh::geomodel
