// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Fractures as plane polygons, and where they come from.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Share of a polygon's size by which its corners may be off one plane: files round their numbers to five digits or so.
inline constexpr double plane_share = 1e-3;

struct Fracture {
  std::string name;
  std::vector<Vec3> corners;  ///< in order, three or more, the last joined to the first
  std::size_t line = 0;       ///< in the file; 0: none
};

/// A disc or ellipse. Its own x axis has the half length `major`, its own y axis `minor`.
struct Ellipse {
  Vec3 center;
  double major = 0, minor = 0;
  Vec3 x_axis, y_axis;  ///< unit vectors at right angles
};

/// Corners at equal steps of the angle. Either on the ellipse, or moved out until the polygon has the ellipse's area.
enum class PolygonSize { inscribed, same_area };
std::vector<Vec3> polygon_of(const Ellipse& ellipse, int n_corners, PolygonSize size);

/// The unit vectors along the strike and down the dip of a plane: azimuth of the dip clockwise from north (y), dip
/// downwards from the horizontal; degrees.
struct PlaneAxes {
  Vec3 strike, dip;
};
PlaneAxes axes_of_plane(double dip_direction, double dip);

/// Why the corners are those of no plane polygon: on one line, or farther than plane_share off the mean plane; empty
/// where they are.
std::string plane_fault(const std::vector<Vec3>& corners);

double area_of(const std::vector<Vec3>& polygon);
/// The part of a convex polygon in the box; empty where there is none.
std::vector<Vec3> clipped(std::vector<Vec3> polygon, const Box3& box);

}  // namespace geomesh::geomodel
