// SPDX-License-Identifier: MIT
/// @file
/// Finds where surfaces that were remeshed within a tolerance had sharp feature edges in the input.
#pragma once

#include <span>

#include "geomesh/core/plc.hpp"
#include "search/closest_point.hpp"

namespace geomesh {

/// Edges of the input along which two facets of one patch meet at a small angle. Remeshing has to keep that angle.
class InputCreases {
 public:
  /// No feature edges.
  InputCreases() = default;
  /// `facet_patch` has the patch of each facet. Two facets of a patch make a feature edge if they meet at less than
  /// `degrees`. `reach` is the distance by which remeshing may have moved a feature edge. O(n log n).
  InputCreases(const PiecewiseLinearComplex& plc, std::span<const Index> facet_patch, double degrees, double reach);

  /// Returns whether two mesh faces of the patch, along the edge (a, b) with third corners x and y, represent a feature
  /// edge of the input: they meet at a small angle, and the edge is within reach of a feature edge. O(log n).
  bool has_fold(Index patch, const Vec3& a, const Vec3& b, const Vec3& x, const Vec3& y) const;

 private:
  search::ClosestPointTrees edges_;  // by patch
  double degrees_ = 0, reach_ = 0;
};

}  // namespace geomesh
