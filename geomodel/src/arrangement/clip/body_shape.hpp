// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What is inside a body: its closed oriented triangles, or, where it is open, the rays along which that is still
/// defined.
#pragma once

#include <map>
#include <optional>

#include "arrangement/model/ingest.hpp"
#include "arrangement/model/winding.hpp"

namespace geomesh::geomodel::arrangement {

/// A body ready for winding numbers.
struct BodyShape {
  Index surface = no_index;
  std::vector<Triangle> triangles;  ///< over the complex' points, one for each input triangle, consistently oriented
  std::vector<std::int8_t> orientation;  ///< per input triangle: -1 where `triangles` turns it round
  bool closed = false;
  double border_length = 0;
  Vec3 border_place;
  /// Closed bodies: any axis will do. Open ones: a direction that leads away from all of the border, which lies beyond
  /// one side of the box. Any cap beyond that side closes such a "rooted" body. None: inside is not defined.
  std::optional<RayDirection> open_direction;
  bool has_inside() const { return closed || open_direction.has_value(); }
};

BodyShape body_shape(const Complex& complex, const Ingested& ingested, const SurfaceList& surfaces, Index surface,
                     const std::optional<Box3>& box);

}  // namespace geomesh::geomodel::arrangement
