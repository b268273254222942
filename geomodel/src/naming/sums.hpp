// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Compensated floating-point sums, and volumes and areas that are summed in this way.
#pragma once

#include <cmath>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Compensated sum (Neumaier 1974, improved Kahan-Babuska algorithm): the error does not grow with the number of terms.
class CompensatedSum {
 public:
  void add(double term) {
    const double sum = sum_ + term;
    correction_ += std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }
  double value() const { return sum_ + correction_; }

 private:
  double sum_ = 0, correction_ = 0;
};

inline double norm(const Vec3& v) { return std::sqrt(dot(v, v)); }

/// Returns the signed volume of a tetrahedron: positive where orient3d is positive, up to rounding.
inline double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return dot(cross(b - a, c - a), d - a) / 6;
}
inline double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) { return norm(cross(b - a, c - a)) / 2; }

}  // namespace geomesh::geomodel
