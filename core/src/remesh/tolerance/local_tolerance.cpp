// SPDX-License-Identifier: MIT
#include "remesh/tolerance/local_tolerance.hpp"

#include <algorithm>

#include "quality/measure/shape.hpp"

namespace geomesh::remesh {

double LocalTolerance::least_at(std::span<const Vec3> points) const {
  double least = greatest_;
  if (!varies_) return least;
  for (const Vec3& p : points) least = std::min(least, by_place_.at(p));
  return least;
}

double LocalTolerance::least_at(std::span<const Vec3> points, search::RecentPlaces& recent) const {
  double least = greatest_;
  if (!varies_) return least;
  for (const Vec3& p : points)
    least = std::min(least, recent.at(p, [&](const search::RecentPlaces::Known& last) {
      return last.value < 0 ? by_place_.at(p) : by_place_.at_beside(p, no_index, last.place, last.value);
    }));
  return least;
}

double LocalTolerance::most_on(const std::array<Vec3, 3>& corners) const {
  if (!varies_ || !(by_place_.steepest() < std::numeric_limits<double>::infinity())) return greatest_;
  const auto& [a, b, c] = corners;
  // No point of a triangle is farther from its centroid than two thirds of its longest side.
  const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
  const double at_centroid = by_place_.at((1.0 / 3) * (a + b + c));
  return std::min(greatest_, at_centroid + 2.0 / 3 * longest * by_place_.steepest());
}

}  // namespace geomesh::remesh
