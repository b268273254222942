// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds heights of a surface over points of the map.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "geomesh/core/predicates.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Finds which triangles of a surface lie above or below a point of the map, by exact orientation; a grid of cells
/// makes a query constant time for evenly spaced triangles. Vertical triangles are never found.
class MapLocator {
 public:
  explicit MapLocator(const TriangulatedSurface& surface);

  struct Hit {
    Index triangle = no_index;
    std::size_t count = 0;  ///< number of triangles above or below the point; > 1 on shared edges and overhangs
    bool strictly = false;  ///< whether the point is inside the triangle and on none of its edges
  };
  Hit find(Vec2 p) const;
  /// Calls found(triangle, strictly) for triangles above or below p; `strictly`: p is inside and on no edge.
  void for_each(Vec2 p, const std::function<void(Index triangle, bool strictly)>& found) const;
  /// Returns the height of the triangle's plane at p; at a corner of the triangle exactly that corner's height.
  double height(Index triangle, Vec2 p) const;
  /// Returns the height of the surface at p, or nothing beside the surface.
  std::optional<double> height(Vec2 p) const;

 private:
  std::size_t cell_of(double x, double min, double step) const;
  const TriangulatedSurface& surface_;
  Box3 bounds_;
  std::size_t n_ = 1;  ///< cells each way
  std::vector<std::vector<Index>> cells_;
};

}  // namespace geomesh::geomodel
