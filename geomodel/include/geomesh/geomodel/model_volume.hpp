// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The model volume: a box, a box with a margin around the data, a rotated box, or a polygon on the map extruded
/// between two heights.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// The project's key `box`, in the project's coordinates. Lengths in m.
struct VolumeSpec {
  enum class Shape {
    box,      ///< `min` and `max`
    margin,   ///< a box around all points of the surfaces, enlarged by a margin
    turned,   ///< `center`, `size`, `azimuth`
    polygon,  ///< of the map
  } shape = Shape::box;
  Box3 box;
  Vec3 margin;        ///< margin along the box's own x, y and z
  Vec2 center, size;  ///< in the map
  /// Angle from y (north) clockwise to the box's own y axis in degrees; for margin and turned boxes.
  double azimuth = 0;
  std::vector<Vec2> polygon;
  std::optional<double> bottom, top;  ///< heights of bottom and top; for all kinds but `box`
  /// Names of horizons given instead of heights, below and above which nothing is meshed.
  std::string bottom_surface, top_surface;
};

struct ModelVolume {
  std::optional<Box3> box;  ///< the box, if the volume is one along the axes
  /// Otherwise its sides, closed and oriented outward: the vertical ones in order, then zmin and zmax.
  std::vector<TriangulatedSurface> sides;
  Box3 bounds;
  double volume = 0;  ///< m3
  std::string note;   ///< description of the box, if it was derived from the data
};

/// Coordinates are those of `surfaces`, which are the project's minus `origin`. Sides of a turned box are named as
/// those of a box, by its own axes; those of a polygon `side_1` ... by the corner at which they begin, `zmin` and
/// `zmax`. Throws Error{usage} if a polygon crosses itself, if the bottom is not below the top, or if there is no data
/// around which to lay a margin.
ModelVolume make_volume(const VolumeSpec& spec, const std::vector<TriangulatedSurface>& surfaces, const Vec3& origin);

/// Returns the bounding box of all points of the surfaces.
Box3 bounds_of(const std::vector<TriangulatedSurface>& surfaces);

}  // namespace geomesh::geomodel
