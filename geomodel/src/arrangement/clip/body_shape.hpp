// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines the inside of a body: from its closed oriented triangles or, if it is open, along rays for which the
/// inside is still defined.
#pragma once

#include <map>
#include <optional>

#include "arrangement/model/ingest.hpp"
#include "arrangement/model/winding.hpp"

namespace geomesh::geomodel::arrangement {

/// A body, prepared for computing winding numbers around points.
struct BodyShape {
  Index surface = no_index;
  /// Consistently oriented triangles over the complex' points, one for each input triangle.
  std::vector<Triangle> triangles;
  /// Per input triangle: -1 if `triangles` lists it with its orientation reversed.
  std::vector<std::int8_t> orientation;
  bool closed = false;
  double border_length = 0;
  Vec3 border_place;
  /// Direction of rays for winding numbers about an open body; it leads away from all of the body's border. That border
  /// must lie beyond one side of the box, so that a cap beyond this side would close the body. Empty if the body is
  /// closed, so that any direction serves, or if its inside is not defined.
  std::optional<RayDirection> open_direction;
  bool has_inside() const { return closed || open_direction.has_value(); }
};

BodyShape body_shape(const Complex& complex, const Ingested& ingested, const SurfaceList& surfaces, Index surface,
                     const std::optional<Box3>& box);

}  // namespace geomesh::geomodel::arrangement
