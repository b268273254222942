// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Fractures as plane polygons, and ellipses from which they are made.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Largest distance of a polygon's corners from one plane, as a share of its size: files round to about five digits.
inline constexpr double plane_share = 1e-3;

struct Fracture {
  std::string name;
  std::vector<Vec3> corners;  ///< three or more corners of the fracture in order; the last is connected to the first
  std::size_t line = 0;       ///< number of the fracture's line in the file; 0: none
};

/// A fracture in the shape of an ellipse or disc, with the half axes `major` (its own x axis) and `minor` (its own y
/// axis).
struct Ellipse {
  Vec3 center;
  double major = 0, minor = 0;
  Vec3 x_axis, y_axis;  ///< perpendicular unit vectors
};

/// How an ellipse becomes a polygon, whose corners are at equal steps of the angle: either on the ellipse, or moved
/// outwards until the polygon has the area of the ellipse.
enum class PolygonSize { inscribed, same_area };
std::vector<Vec3> polygon_of(const Ellipse& ellipse, int n_corners, PolygonSize size);

/// Unit vectors along the strike and down the dip of a plane. The plane is given in degrees by the azimuth of its dip,
/// clockwise from north (y), and by its dip downwards from the horizontal.
struct PlaneAxes {
  Vec3 strike, dip;
};
PlaneAxes axes_of_plane(double dip_direction, double dip);

/// Returns why corners do not form a plane polygon: they are on one line, or too far from their mean plane (more than
/// the share plane_share of the polygon's size). Empty if they do.
std::string plane_fault(const std::vector<Vec3>& corners);

double area_of(const std::vector<Vec3>& polygon);
std::vector<Vec3> clipped(std::vector<Vec3> polygon, const Box3& box);

}  // namespace geomesh::geomodel
