// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Heights of a horizon carried on beyond its nodes, towards a fault and over it.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Planes that are fitted with weights to the nodes of one side near a place (moving least squares; Levin, The
/// approximation power of moving least-squares, Math. Comp. 67, 1998).
class CarriedHeights {
 public:
  /// `edge`: median edge of the horizon in the map. The surface outlives it, and may get more points.
  CarriedHeights(const TriangulatedSurface& surface, double edge);
  void add(VertexIndex node);
  /// The height at p of the plane through the nodes about the nearest one, within reach of p. `across`: the direction
  /// across a fault, of length one; distances along it count more, since throw changes along the strike. Nought: no
  /// direction counts more.
  std::optional<double> at(const Vec3& p, const Vec2& across, double reach) const;

 private:
  template <class F>
  void for_each_near(const Vec3& p, double radius, F&& visit) const;
  std::pair<long, long> cell_of(double x, double y) const;

  const TriangulatedSurface& surface_;
  double edge_, cell_;
  std::map<std::pair<long, long>, std::vector<VertexIndex>> cells_;
};

}  // namespace geomesh::geomodel
