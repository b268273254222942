// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A scalar field as the isosurface needs it: values at places, and bounds where the field can prove them.
#pragma once

#include <cmath>
#include <span>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

inline double length_of(const Vec3& v) { return std::sqrt(dot(v, v)); }

/// Interval of values; empty where low > high.
struct Range {
  double low, high;
  bool holds(double v) const { return low <= v && v <= high; }
};

/// The linear function value + gradient . (p - place).
struct LinearFunction {
  Vec3 place;
  double value = 0;
  Vec3 gradient;
  double operator()(const Vec3& p) const { return value + dot(gradient, p - place); }
};

class ScalarField {
 public:
  ScalarField() = default;
  ScalarField(const ScalarField&) = delete;
  ScalarField& operator=(const ScalarField&) = delete;
  virtual ~ScalarField() = default;

  /// Writes the value at each place.
  virtual void values(std::span<const Vec3> places, std::span<double> out) const = 0;
  /// Length below which the field has no features of its own, as the spacing of a grid; 0: not known.
  virtual double resolution() const { return 0; }
  /// True: value_range and residual_range are proven. False: nothing is known between samples.
  virtual bool has_bounds() const { return false; }
  /// Contains every value of the field in the box. Preconditions: has_bounds(), the box lies in the domain.
  virtual Range value_range(const Box3&) const { return {1, 0}; }
  /// Contains every value of field minus `linear` in the box, up to rounding. Precondition: has_bounds().
  virtual Range residual_range(const Box3&, const LinearFunction&) const { return {1, 0}; }
};

}  // namespace geomesh::geomodel
