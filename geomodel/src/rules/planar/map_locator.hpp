// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Heights of a surface over points of the map.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "geomesh/core/predicates.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Which triangles of a surface lie over or under a point of the map, by exact orientation; a grid of cells makes
/// questions cheap: constant time for evenly spaced triangles. Vertical triangles are never found.
class MapLocator {
 public:
  explicit MapLocator(const TriangulatedSurface& surface);

  struct Hit {
    Index triangle = no_index;
    std::size_t count = 0;  ///< how many triangles; more than one on shared edges or where the surface overhangs
    bool strictly = false;  ///< inside the triangle, on none of its edges
  };
  Hit find(Vec2 p) const;
  /// `found` is given each triangle over or under p, and whether p is strictly inside it.
  void for_each(Vec2 p, const std::function<void(Index triangle, bool strictly)>& found) const;
  /// Height of the triangle's plane; at one of its corners exactly that corner's.
  double height(Index triangle, Vec2 p) const;
  /// Height over p, nothing beside the surface.
  std::optional<double> height(Vec2 p) const;

 private:
  std::size_t cell_of(double x, double min, double step) const;
  const TriangulatedSurface& surface_;
  Box3 bounds_;
  std::size_t n_ = 1;  ///< cells each way
  std::vector<std::vector<Index>> cells_;
};

}  // namespace geomesh::geomodel
