// SPDX-License-Identifier: MIT
/// @file
/// Shapes of all tetrahedra in 18 bytes each: any percentile is found exactly by measuring few of them again.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geomesh/core/quality.hpp"

namespace geomesh {

/// The measured quantities. A tetrahedron has one value of each, and four solid angles.
enum class ShapeMeasure : std::uint8_t { min_dihedral, max_dihedral, radius_ratio, aspect, mean_ratio, solid_angle };
inline constexpr std::size_t n_shape_measures = 6;

/// The member of the statistics that holds the distribution of a measure.
Distribution& result_of(ShapeStatistics& statistics, ShapeMeasure which);

/// Statistics of a set of tetrahedra without percentiles, which can be combined from parts.
struct ShapeSums {
  ShapeStatistics counts;  ///< statistics in which only histograms, number of tetrahedra and volume are set
  std::array<double, n_shape_measures> sum{}, least, greatest;
  std::size_t n_below_10 = 0, n_above_24_85 = 0;

  ShapeSums();
  void add(const TetrahedronShape& shape);
  void join(const ShapeSums& other);
  ShapeStatistics statistics() const;
};

/// Stores each value as one of 65,536 steps of its scale, which preserve the order: a percentile is in its rank's step.
class ShapeTable {
 public:
  ShapeTable(std::span<const Vec3> points, std::span<const Tetrahedron> tetrahedra);

  /// Measures the tetrahedra listed in `rows` and adds to `sums`. Calls for disjoint lists may run concurrently.
  void measure(std::span<const Index> rows, ShapeSums& sums);

  /// Returns the first percentile of the measure `which` over the tetrahedra listed in `rows`. Precondition: measure()
  /// was called for them. O(n); few tetrahedra are measured again.
  double first_percentile(ShapeMeasure which, std::span<const Index> rows) const;

  /// Returns the tetrahedra whose least dihedral angle is below `angle` (degrees), and in any case the `n_least`
  /// tetrahedra with the least angles. They are ordered by least angle, then by row. Precondition: all were measured.
  std::vector<std::pair<double, Index>> with_least_angles(double angle, std::size_t n_least) const;

  TetrahedronShape shape(Index row) const;

 private:
  using Step = std::uint16_t;
  std::size_t values_a_row(ShapeMeasure which) const { return which == ShapeMeasure::solid_angle ? 4 : 1; }
  /// Returns the step (0 to 65,535) of the value that has the given rank when the values of measure `which` are sorted
  /// over the tetrahedra in `rows`, and the number of values in lower steps.
  std::pair<Step, std::size_t> step_at(std::size_t rank, ShapeMeasure which, std::span<const Index> rows) const;

  std::span<const Vec3> points_;
  std::span<const Tetrahedron> tetrahedra_;
  std::array<std::vector<Step>, n_shape_measures> steps_;  // values as 16-bit steps: by measure, tetrahedron, corner
};

}  // namespace geomesh
