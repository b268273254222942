// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Interface of a scalar field for making isosurfaces: values at places, and bounds if the field can prove them.
#pragma once

#include <cmath>
#include <span>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

inline double length_of(const Vec3& v) { return std::sqrt(dot(v, v)); }

/// Interval of values; empty if low > high.
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

  /// Writes the field's value at each place.
  virtual void values(std::span<const Vec3> places, std::span<double> out) const = 0;
  /// Length below which the field has no features of its own, for example the spacing of a grid; 0: not known.
  virtual double resolution() const { return 0; }
  /// Returns true if value_range and residual_range are proven bounds. If false, nothing is known between samples.
  virtual bool has_bounds() const { return false; }
  /// Returns an interval that contains every value of the field in the box. Preconditions: has_bounds(), and the box
  /// lies in the domain.
  virtual Range value_range(const Box3&) const { return {1, 0}; }
  /// Returns an interval that contains every value of the field minus `linear` in the box, up to rounding.
  /// Precondition: has_bounds().
  virtual Range residual_range(const Box3&, const LinearFunction&) const { return {1, 0}; }
};

}  // namespace geomesh::geomodel
