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

/// The key `box` of a project: the shape of the model volume, in the project's coordinates. Lengths in m.
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
  /// Azimuth of the box's own y axis: its angle clockwise from north in degrees. For rotated boxes, also with a margin.
  double azimuth = 0;
  std::vector<Vec2> polygon;
  /// Heights of the bottom and the top of the model volume, for all shapes but `box`.
  std::optional<double> bottom, top;
  /// Names of horizons that bound the model volume below and above, instead of heights; nothing is meshed beyond them.
  std::string bottom_surface, top_surface;
};

struct ModelVolume {
  std::optional<Box3> box;  ///< the model volume, if it is a box along the axes
  /// Sides of a model volume that is not a box along the axes, closed and oriented outward: first the vertical sides in
  /// order, then zmin and zmax.
  std::vector<TriangulatedSurface> sides;
  Box3 bounds;
  double volume = 0;  ///< m3
  std::string note;   ///< description of the box, if it was derived from the extent of the data
};

/// Makes the model volume in the coordinates of `surfaces`, which are the project's minus `origin`. Sides of a rotated
/// box are named like those of a box along the axes. The sides of a polygon are named `side_1` ... from the corner at
/// which they begin, `zmin` and `zmax`. Throws Error{usage} if a polygon crosses itself, if the bottom is not below the
/// top, or if a margin is requested and there are no data.
ModelVolume make_volume(const VolumeSpec& spec, const std::vector<TriangulatedSurface>& surfaces, const Vec3& origin);

/// Returns the bounding box of all points of the surfaces.
Box3 bounds_of(const std::vector<TriangulatedSurface>& surfaces);

}  // namespace geomesh::geomodel
