// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Scalar fields from which isosurfaces are made: they have values at places, and bounds if the field can prove them.
#pragma once

#include <cmath>
#include <span>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

inline double length_of(const Vec3& v) { return std::sqrt(dot(v, v)); }

/// An interval of values; empty if low > high.
struct Range {
  double low, high;
  bool holds(double v) const { return low <= v && v <= high; }
};

/// The linear function of p whose value is value + gradient . (p - place).
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

  virtual void values(std::span<const Vec3> places, std::span<double> out) const = 0;
  /// Returns the length below which the field has no features, for example the spacing of a grid; 0 if it is not known.
  virtual double resolution() const { return 0; }
  /// Returns whether value_range and residual_range are proven bounds of the field. If not, nothing is known between
  /// the places at which it was evaluated.
  virtual bool has_bounds() const { return false; }
  /// Returns an interval that contains every value of the field in a box. Preconditions: has_bounds(), and the box lies
  /// in the domain of the field.
  virtual Range value_range(const Box3&) const { return {1, 0}; }
  /// Returns an interval that contains all values in a box of the field minus `linear`, to rounding. Precondition:
  /// has_bounds().
  virtual Range residual_range(const Box3&, const LinearFunction&) const { return {1, 0}; }
};

}  // namespace geomesh::geomodel
