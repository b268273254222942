// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The model volume: a box, a box by margin about the data, a turned box, or a polygon of the map extruded between two
/// heights.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// What the project's `box` asks for, in the project's coordinates. Lengths in m.
struct VolumeSpec {
  enum class Shape {
    box,      ///< `min` and `max`
    margin,   ///< about all points of the surfaces
    turned,   ///< `center`, `size`, `azimuth`
    polygon,  ///< of the map
  } shape = Shape::box;
  Box3 box;
  Vec3 margin;         ///< along the box's own x, y, z
  Vec2 center, size;   ///< in the map
  double azimuth = 0;  ///< degrees clockwise from y (north) to the box's own y axis; for margin and turned
  std::vector<Vec2> polygon;
  std::optional<double> bottom, top;        ///< heights; for all but `box`
  std::string bottom_surface, top_surface;  ///< instead: horizons, beyond which nothing is meshed
};

struct ModelVolume {
  std::optional<Box3> box;                 ///< where the volume is a box along the axes
  std::vector<TriangulatedSurface> sides;  ///< else: its sides, closed and outward; side by side, at last zmin and zmax
  Box3 bounds;
  double volume = 0;  ///< m3
  std::string note;   ///< where the box was found from the data: what it is
};

/// In the frame of `surfaces`, which is the project's less `origin`. Sides of a turned box are named as those of a box,
/// by its own axes; those of a polygon `side_1` ... by the corner at which they begin, `zmin` and `zmax`. Throws
/// Error{usage}: a polygon that crosses itself, no height between bottom and top, or no data to lay a margin about.
ModelVolume make_volume(const VolumeSpec& spec, const std::vector<TriangulatedSurface>& surfaces, const Vec3& origin);

/// Of all their points.
Box3 bounds_of(const std::vector<TriangulatedSurface>& surfaces);

}  // namespace geomesh::geomodel
