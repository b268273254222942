// SPDX-License-Identifier: MIT
/// @file
/// The quality measure chosen by the user, in the form in which local operations use it. Its values are called shapes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "quality/measure/dihedral_measure.hpp"
#include "quality/measure/link_kernels.hpp"
#include "quality/measure/measures.hpp"

namespace geomesh::remesh {

/// Weight, in sums over cells (CellQuality::worth), of the amount by which a cell's shape is below the limit `poor`.
inline constexpr double poor_weight = 3;

/// Least dihedral angle in degrees below which a cell is bad.
inline constexpr double bad_angle = 8;

/// Measures the quality of one cell at a time. The default measure is inlined; the others cost a call. The shapes of a
/// whole link are computed by link_kernels.hpp.
class CellQuality {
 public:
  explicit CellQuality(QualityMeasure measure = QualityMeasure::dihedral);

  QualityMeasure measure() const { return measure_; }
  const LinkKernels& kernels() const { return *kernels_; }

  /// Returns the measure of (a, b, c, p): in (0, `largest`] for positive cells, six times the volume for others.
  double shape(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) const {
    if (measure_ == QualityMeasure::dihedral) [[likely]]
      return shape_of_cell<DihedralMeasure>(a, b, c, p);
    return rules_->shape(a, b, c, p);
  }
  /// Appends the gradients, by the apex p, of all terms of the shape that are at most `limit`: six terms for dihedral
  /// angles, one for the ratios. The cell must be positive.
  void append_gradients(const std::array<Vec3, 3>& face, const Vec3& p, double limit, std::vector<Vec3>& out) const {
    rules_->append_gradients(face, p, limit, out);
  }

  /// Returns the weight of a cell in a sum over many: its shape, reduced below 12 degrees, so that few slivers are not
  /// accepted in exchange for improving many others.
  double worth(double shape) const { return shape < poor_ ? poor_weight * shape - (poor_weight - 1) * poor_ : shape; }
  /// Returns the shape that corresponds to a dihedral angle in degrees: that of the sliver with this least angle.
  double of_angle(double degrees) const { return rules_->of_angle(degrees); }
  /// The shape that corresponds to the dihedral angle `bad_angle`.
  double bad() const { return bad_; }

  /// Returns the shape of the regular tetrahedron, or slightly more. No cell is better.
  double largest() const { return largest_; }
  /// Suppose that two cells divide the dihedral angle that cell (a, b, x, y) has at its edge (x, y) between them.
  /// Returns an upper bound of the shape of the worse of the two cells, which also bounds the mean of their worths.
  /// Returns NaN if a face has no area.
  double most_of_half_angle(const Vec3& a, const Vec3& b, const Vec3& x, const Vec3& y) const {
    constexpr double rounding = 1e-6;
    const Vec3 d = y - x, m = cross(d, a - x), n = cross(d, b - x);
    const double cosine = dot(m, n) / std::sqrt(dot(m, m) * dot(n, n));
    const double sine_of_half = std::sqrt(std::max(0.5 - 0.5 * cosine, 0.0));
    if (measure_ == QualityMeasure::dihedral) [[likely]]
      return DihedralMeasure::most_with_angle(sine_of_half, 0) + rounding;
    return rules_->most_with_angle(sine_of_half, std::sqrt(std::max(0.5 + 0.5 * cosine, 0.0))) + rounding;
  }

 private:
  struct Rules {
    double (*shape)(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p);
    void (*append_gradients)(const std::array<Vec3, 3>& face, const Vec3& p, double limit, std::vector<Vec3>& out);
    double (*of_angle)(double degrees);
    double (*most_with_angle)(double sine, double cosine);
    double poor, largest;
  };
  template <class Measure>
  struct RulesOf;
  static const std::array<Rules, n_quality_measures> rules;

  QualityMeasure measure_;
  const Rules* rules_;
  const LinkKernels* kernels_;
  double poor_, bad_, largest_;
};

}  // namespace geomesh::remesh
