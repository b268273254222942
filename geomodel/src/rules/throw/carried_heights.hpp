// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Extrapolates heights of a horizon beyond its nodes, towards a fault and across it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Heights of planes that are fitted with weights to the nodes on one side of a fault near a place (moving least
/// squares; Levin, The approximation power of moving least-squares, Math. Comp. 67, 1998).
class CarriedHeights {
 public:
  /// `edge` is the median edge length of the horizon in the map. The horizon must outlive this object and may get more
  /// points.
  CarriedHeights(const TriangulatedSurface& surface, double edge);
  void add(VertexIndex node);
  /// Returns the height at p of the plane fitted to the nodes around the nearest node, if that is within reach of p.
  /// `across` is the unit vector perpendicular to the fault's strike; distances along the strike have a larger weight,
  /// since throw changes along it. If `across` is zero, all directions are equal.
  std::optional<double> at(const Vec3& p, const Vec2& across, double reach) const;

 private:
  template <class F>
  void for_each_near(const Vec3& p, double radius, F&& visit) const;
  std::pair<std::int64_t, std::int64_t> cell_of(double x, double y) const;

  const TriangulatedSurface& surface_;
  double edge_, cell_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<VertexIndex>> cells_;
};

}  // namespace geomesh::geomodel
