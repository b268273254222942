// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds places outside the original body that were removed with its inside, because merging had moved them into it.
#pragma once

#include "arrangement/clip/body_shape.hpp"
#include "arrangement/clip/clip.hpp"
#include "geomesh/core/surface_distance.hpp"

namespace geomesh::geomodel::arrangement {

/// Facets of one surface, as indices in the arrangement's list of facets.
struct CutOff {
  std::vector<Index> gone, left;  ///< the surface's facets that a body cut off, and those that were kept
};

/// A body in its original shape, before anything was merged within `tolerance`.
class BodyAsGiven {
 public:
  /// Prepares queries of the body, which must outlive this object. O(n log n).
  BodyAsGiven(const TriangulatedSurface& body, const BodyShape& shape, double tolerance);

  /// Returns the largest distance from the kept facets of points that were outside the body and lie on edges of removed
  /// facets. Points within a thousandth of the tolerance of the body count as on it. If no facets are kept, the result
  /// is the extent of the removed ones. Sampled points are no closer to each other than the tolerance, or 1/256 of
  /// their edge. O(n log n) for the kept facets, O(log n) for each sample, and O(n) for each that is farther than all
  /// before it.
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
