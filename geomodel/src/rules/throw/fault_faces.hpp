// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A fault as its triangles: on which side of it a place lies, how far off, and where along its strike.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "arrangement/search/bvh.hpp"
#include "geomesh/geomodel/surface.hpp"
#include "naming/sums.hpp"
#include "rules/throw/nearest_point.hpp"

namespace geomesh::geomodel {

/// A place beside a fault.
struct Beside {
  double distance;
  double across;   ///< in the map at the place's own height, positive above the fault
  double along;    ///< the strike
  Vec2 direction;  ///< of `across`
  bool is_within;  ///< not beyond the fault's end
};

/// Triangles with normals to one side, boxes about them, and the strike of all. A query costs about as many triangles
/// as lie within its reach, or nearer than the nearest one.
class FaultFaces {
 public:
  explicit FaultFaces(const TriangulatedSurface& fault);

  /// From the nearest triangle that is not level; beyond the fault's ends its plane goes on. Nothing further off than
  /// reach.
  std::optional<Beside> beside(const Vec3& p, double reach) const;

 private:
  struct Face {
    std::array<Vec3, 3> corners;
    Vec3 normal;
    Box3 bounds;
    bool is_further(const Vec3& p, double reach) const;
    /// Over the triangle, or nearly so over a bend between two.
    std::pair<double, bool> distance(const Vec3& p) const;
  };

  bool may_be_near(const Vec3& p, double reach) const;
  /// Ascending.
  std::vector<Index> faces_within(const Vec3& p, double reach) const;

  std::vector<Face> faces_;
  std::vector<Index> steep_;  ///< those that are not level
  NearestPoint steep_centres_;
  arrangement::BoxTree tree_;
  Box3 bounds_;
  Vec2 strike_{1, 0};
};

}  // namespace geomesh::geomodel
