// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines what is inside a body, from its closed oriented triangles or, if it is open, along the rays for which
/// inside is still defined.
#pragma once

#include <map>
#include <optional>

#include "arrangement/model/ingest.hpp"
#include "arrangement/model/winding.hpp"

namespace geomesh::geomodel::arrangement {

/// A body, prepared for winding numbers.
struct BodyShape {
  Index surface = no_index;
  /// Consistently oriented triangles over the complex' points, one for each input triangle.
  std::vector<Triangle> triangles;
  std::vector<std::int8_t> orientation;  ///< for each input triangle: -1 if `triangles` has it inverted
  bool closed = false;
  double border_length = 0;
  Vec3 border_place;
  /// Directions of rays for winding numbers. Closed bodies: any axis. Open ones: a direction that leads away from all
  /// of the border, which lies beyond one side of the box, so that any cap beyond that side closes such a "rooted"
  /// body. None: inside is not defined.
  std::optional<RayDirection> open_direction;
  bool has_inside() const { return closed || open_direction.has_value(); }
};

BodyShape body_shape(const Complex& complex, const Ingested& ingested, const SurfaceList& surfaces, Index surface,
                     const std::optional<Box3>& box);

}  // namespace geomesh::geomodel::arrangement
