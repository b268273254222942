// SPDX-License-Identifier: MIT
#include "recover/start/level_frame.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"
#include "recover/model/recovery_budget.hpp"

namespace geomesh::recover {

namespace {

/// Returns the normal of a subfacet, whose length is twice the area.
Vec3 area_of(const std::vector<Vec3>& points, const Constraints& constraints, Index subfacet) {
  const Triangle& t = constraints.subfacets[subfacet].vertices;
  const Vec3& origin = points[t[0]];
  if (!constraints.is_piece(subfacet)) return cross(points[t[1]] - origin, points[t[2]] - origin);
  Vec3 sum;
  for (const DirectedEdge& e : constraints.piece_of(subfacet).border)
    sum = sum + cross(points[e[0]] - origin, points[e[1]] - origin);
  return sum;
}

/// Returns the sum x + y, or nothing if the exact sum is not a double.
std::optional<double> exact_sum(double x, double y) {
  const double sum = x + y, of_y = sum - x, of_x = sum - of_y;
  if (of_y != y || of_x != x) return std::nullopt;
  return sum;
}
std::optional<double> exact_product(double x, double y) {
  const double product = x * y;
  if (std::fma(x, y, -product) != 0) return std::nullopt;
  return product;
}

/// A shear that adds to coordinate `axis` multiples of the two other coordinates.
class Shear {
 public:
  Shear(const Vec3& normal, std::size_t axis) : axis_(axis) {
    for (std::size_t k = 0; k < 2; ++k)
      slopes_[k] =
          std::round(normal[other(k)] / normal[axis] / recovery_budget.slope_step) * recovery_budget.slope_step;
  }

  bool is_none() const { return slopes_[0] == 0 && slopes_[1] == 0; }
  std::optional<double> height(const Vec3& p) const {
    std::optional<double> sum = p[axis_];
    for (std::size_t k = 0; k < 2 && sum; ++k) {
      const std::optional<double> part = exact_product(slopes_[k], p[other(k)]);
      sum = part ? exact_sum(*sum, *part) : std::nullopt;
    }
    return sum;
  }
  bool makes_level(const std::vector<Vec3>& points, const Triangle& t) const {
    const std::optional<double> at = height(points[t[0]]);
    return at && height(points[t[1]]) == at && height(points[t[2]]) == at;
  }
  bool makes_most_level(const std::vector<Vec3>& points, const Constraints& constraints) const {
    double level = 0, all = 0;
    for (Index f = 0; f < constraints.subfacets.size(); ++f) {
      const double area = length(area_of(points, constraints, f));
      all += area;
      if (makes_level(points, constraints.subfacets[f].vertices)) level += area;
    }
    return 2 * level > all;
  }
  std::optional<std::vector<Vec3>> of(std::vector<Vec3> points) const {
    for (Vec3& p : points) {
      const std::optional<double> at = height(p);
      if (!at) return std::nullopt;
      p[axis_] = *at;
    }
    return points;
  }

 private:
  std::size_t other(std::size_t k) const { return (axis_ + 1 + k) % 3; }

  std::size_t axis_;
  std::array<double, 2> slopes_{};
};

/// Returns the axes by decreasing component, rounded to the step of slopes, of a plane's normal along them.
std::array<std::size_t, 3> axes_along(const Vec3& normal, const Vec3& extents) {
  const double largest = std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)});
  const auto nearness = [&](std::size_t axis) {
    return std::round(std::fabs(normal[axis]) / largest / recovery_budget.slope_step);
  };
  std::array<std::size_t, 3> axes{2, 1, 0};
  std::stable_sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) {
    return nearness(a) != nearness(b) ? nearness(a) > nearness(b) : extents[a] > extents[b];
  });
  return axes;
}

Vec3 extents_of(const std::vector<Vec3>& points, const Constraints& constraints) {
  Box3 box;
  for (const Subsegment& s : constraints.subsegments)
    for (const VertexIndex v : {s.a, s.b}) box.add(points[v]);
  return box.max - box.min;
}

}  // namespace

std::size_t level_axis(const std::array<Vec3, 3>& corners, const Vec3& extents) {
  const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const std::array<std::size_t, 3> axes = axes_along(normal, extents);
  for (const std::size_t axis : axes)
    if (normal[axis] != 0 && Shear(normal, axis).makes_level({corners.begin(), corners.end()}, {0, 1, 2})) return axis;
  return axes[0];
}

std::optional<std::vector<Vec3>> with_level_facets(const std::vector<Vec3>& points, const Constraints& constraints) {
  Index largest = no_index;
  Vec3 normal;
  for (Index f = 0; f < constraints.subfacets.size(); ++f) {
    const Vec3 area = area_of(points, constraints, f);
    if (!(dot(area, area) > dot(normal, normal))) continue;
    largest = f;
    normal = area;
  }
  if (largest == no_index) return std::nullopt;
  for (const std::size_t axis : axes_along(normal, extents_of(points, constraints))) {
    if (normal[axis] == 0) continue;
    const Shear shear(normal, axis);
    if (shear.is_none()) return std::nullopt;
    if (!shear.makes_level(points, constraints.subfacets[largest].vertices)) continue;
    if (!shear.makes_most_level(points, constraints)) return std::nullopt;
    if (auto out = shear.of(points)) return out;
  }
  return std::nullopt;
}

}  // namespace geomesh::recover
