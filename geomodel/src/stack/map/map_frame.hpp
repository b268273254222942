// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Coordinates of the map, rotated so that the model volume's longest side lies along the first axis.
#pragma once

#include <vector>

#include "geomesh/geomodel/surface.hpp"
#include "stack/map/map_samples.hpp"

namespace geomesh::geomodel {

class MapFrame {
 public:
  /// Rotates the map, unless the outline is an axis-aligned box, whose coordinates remain unchanged.
  MapFrame(const std::vector<Vec2>& outline, bool is_box);
  Vec2 to_frame(const Vec2& p) const;
  Vec2 to_model(const Vec2& p) const;
  TriangulatedSurface to_frame(const TriangulatedSurface& surface) const;
  MapBounds bounds(const std::vector<Vec2>& outline) const;

 private:
  bool is_turned_ = false;
  Vec2 origin_{0, 0}, axis_{1, 0};
};

}  // namespace geomesh::geomodel
