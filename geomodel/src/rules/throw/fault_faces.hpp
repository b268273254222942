// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A fault as a set of triangles: on which side of it a place lies, how far away, and where along its strike.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "arrangement/search/bvh.hpp"
#include "geomesh/geomodel/surface.hpp"
#include "naming/sums.hpp"
#include "rules/throw/nearest_point.hpp"

namespace geomesh::geomodel {

/// Position of a place relative to a fault.
struct Beside {
  double distance;
  double across;   ///< horizontal distance of the place from the fault at the same height, positive above the fault
  double along;    ///< the strike
  Vec2 direction;  ///< of `across`
  bool is_within;  ///< whether the place lies beside the fault, not beyond its end
};

/// Triangles of a fault with normals to one side, their bounding boxes, and the mean strike. A query visits about as
/// many triangles as lie within its reach or are closer than the nearest one.
class FaultFaces {
 public:
  explicit FaultFaces(const TriangulatedSurface& fault);

  /// Returns the position of a place relative to the fault's nearest triangle that is not horizontal, whose plane is
  /// extended beyond the fault's ends. Returns nothing if the place is farther than `reach`.
  std::optional<Beside> beside(const Vec3& p, double reach) const;

 private:
  struct Face {
    std::array<Vec3, 3> corners;
    Vec3 normal;
    Box3 bounds;
    bool is_further(const Vec3& p, double reach) const;
    /// Returns the distance of p from the triangle, and whether p projects onto it, or nearly so at a bend between two
    /// triangles.
    std::pair<double, bool> distance(const Vec3& p) const;
  };

  bool may_be_near(const Vec3& p, double reach) const;
  /// Ascending.
  std::vector<Index> faces_within(const Vec3& p, double reach) const;

  std::vector<Face> faces_;
  std::vector<Index> steep_;  ///< indices of the fault's triangles that are not horizontal
  NearestPoint steep_centres_;
  arrangement::BoxTree tree_;
  Box3 bounds_;
  Vec2 strike_{1, 0};
};

}  // namespace geomesh::geomodel
