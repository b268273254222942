// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Places that were outside a body as given, and were removed with its inside, because merging had moved them into the
/// body.
#pragma once

#include "arrangement/clip/body_shape.hpp"
#include "arrangement/clip/clip.hpp"
#include "geomesh/core/surface_distance.hpp"

namespace geomesh::geomodel::arrangement {

/// Facets of one surface: rows of the arrangement.
struct CutOff {
  std::vector<Index> gone, left;  ///< cut off by a body; those that stay
};

/// A body as given, before anything was merged within `tolerance`.
class BodyAsGiven {
 public:
  /// `body` outlives this. O(n log n).
  BodyAsGiven(const TriangulatedSurface& body, const BodyShape& shape, double tolerance);

  /// How far points on edges of what is gone that were outside of the body are from what is left, at most. Points
  /// within a thousandth of the tolerance of the body count as on it. Where nothing is left it is the extent of what is
  /// gone. Points are no nearer to each other than the tolerance, or a 256th of their edge. O(n log n) for what is
  /// left, O(log n) for each point, and O(n) for each that is farther than all before it.
  Displacement lost(const Arranged& arranged, const CutOff& cut) const;

 private:
  template <typename Visit>
  void visit_beside(const Vec3& a, const Vec3& b, Visit&& visit) const;

  std::vector<Triangle> triangles_;
  SurfaceDistance wall_;
  WindingNumber winding_;
  RayDirection ray_;
  double tolerance_;
};

}  // namespace geomesh::geomodel::arrangement
