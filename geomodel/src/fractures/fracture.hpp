// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Fractures as plane polygons, and where they come from.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Share of a polygon's size by which its corners may be off one plane: files round their numbers to about five digits.
inline constexpr double plane_share = 1e-3;

struct Fracture {
  std::string name;
  std::vector<Vec3> corners;  ///< three or more corners in order; the last is connected to the first
  std::size_t line = 0;       ///< line in the file; 0: none
};

/// A disc or ellipse. Its own x axis has the half length `major`, its own y axis `minor`.
struct Ellipse {
  Vec3 center;
  double major = 0, minor = 0;
  Vec3 x_axis, y_axis;  ///< perpendicular unit vectors
};

/// Polygons have corners at equal steps of the angle, either on the ellipse, or moved outwards until the polygon has
/// the ellipse's area.
enum class PolygonSize { inscribed, same_area };
std::vector<Vec3> polygon_of(const Ellipse& ellipse, int n_corners, PolygonSize size);

/// The unit vectors along the strike and down the dip of a plane. Arguments in degrees: azimuth of the dip clockwise
/// from north (y), dip downwards from the horizontal.
struct PlaneAxes {
  Vec3 strike, dip;
};
PlaneAxes axes_of_plane(double dip_direction, double dip);

/// Returns why the corners do not form a plane polygon: they are on one line, or farther than plane_share from the mean
/// plane; empty if they do.
std::string plane_fault(const std::vector<Vec3>& corners);

double area_of(const std::vector<Vec3>& polygon);
/// Returns the part of a convex polygon in the box; empty if there is none.
std::vector<Vec3> clipped(std::vector<Vec3> polygon, const Box3& box);

}  // namespace geomesh::geomodel
