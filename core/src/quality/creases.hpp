// SPDX-License-Identifier: MIT
/// @file
/// Where surfaces that were remeshed within a tolerance had sharp creases in the input.
#pragma once

#include <span>

#include "geomesh/core/plc.hpp"
#include "search/closest_point.hpp"

namespace geomesh {

/// Edges of the input along which two facets of one patch meet at a small angle: what is remeshed has to keep that
/// angle.
class InputCreases {
 public:
  /// No creases.
  InputCreases() = default;
  /// `facet_patch`: by facet. `degrees`: the angle below which two facets make a crease. `reach`: how far remeshing may
  /// have moved one. O(n log n).
  InputCreases(const PiecewiseLinearComplex& plc, std::span<const Index> facet_patch, double degrees, double reach);

  /// Whether two mesh faces of the patch, along the edge (a, b) with third corners x and y, make a crease of the input:
  /// they meet at a small angle, and the edge is as near to one as it may be. O(log n).
  bool has_fold(Index patch, const Vec3& a, const Vec3& b, const Vec3& x, const Vec3& y) const;

 private:
  search::ClosestPointTrees edges_;  // by patch
  double degrees_ = 0, reach_ = 0;
};

}  // namespace geomesh
