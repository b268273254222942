// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Multiplies z by a factor during meshing (crs.z_scale).
#pragma once

#include <cmath>
#include <unordered_map>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Multiplies heights by a factor and restores them. Powers of two are applied and undone exactly. Other factors round
/// once in each direction; input heights are restored exactly, because the original of each scaled height is stored. If
/// two neighbouring heights scale to the same double, the first is kept. Precondition: factor > 0.
class ZScale {
 public:
  explicit ZScale(double factor) : factor_(factor) {}
  double factor() const { return factor_; }
  bool is_exact() const {
    int exponent = 0;
    return std::frexp(factor_, &exponent) == 0.5;
  }
  void apply(Vec3& p) {
    const double scaled = p.z * factor_;
    if (!is_exact()) given_.emplace(scaled, p.z);
    p.z = scaled;
  }
  void undo(Vec3& p) const {
    const auto at = given_.find(p.z);
    p.z = at != given_.end() ? at->second : p.z / factor_;
  }
  void apply(std::vector<Vec3>& points) {
    for (Vec3& p : points) apply(p);
  }
  void undo(std::vector<Vec3>& points) const {
    for (Vec3& p : points) undo(p);
  }

 private:
  double factor_;
  std::unordered_map<double, double> given_;  ///< never iterated over
};

}  // namespace geomesh::geomodel
