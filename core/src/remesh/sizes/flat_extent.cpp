// SPDX-License-Identifier: MIT
#include "remesh/sizes/flat_extent.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"

namespace geomesh::remesh {

namespace {

/// A surface counts as flat over a length if the root mean square of its distance from the best plane is at most this
/// share of the tolerance. If chords of that length deviate from a surface of constant curvature by the tolerance, the
/// root mean square is 0.3 of it. Normally distributed noise of this share is within the tolerance in all but one of
/// ten thousand places.
constexpr double share_of_tolerance = 0.25;
constexpr unsigned most_levels = 12;

/// Moments of an area: integrals of the coordinates and of their products, relative to an origin.
struct Moments {
  double area = 0;
  Vec3 sum;
  double xx = 0, yy = 0, zz = 0, xy = 0, yz = 0, zx = 0;

  /// Adds a triangle. The integrals are exact: that of a product of coordinates is the product summed over the corners
  /// and the sum of the corners, times a twelfth of the area.
  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double w = 0.5 * length(cross(b - a, c - a)), t = w / 12;
    const Vec3 s = a + b + c;
    area += w;
    sum = sum + (w / 3) * s;
    for (const Vec3& p : {a, b, c, s}) {
      xx += t * p.x * p.x, yy += t * p.y * p.y, zz += t * p.z * p.z;
      xy += t * p.x * p.y, yz += t * p.y * p.z, zx += t * p.z * p.x;
    }
  }

  /// Returns the mean squared distance from the best-fitting plane: the smallest eigenvalue of the covariance matrix.
  double off_plane_squared() const {
    if (!(area > 0)) return 0;
    const Vec3 m = (1 / area) * sum;
    const double a = xx / area - m.x * m.x, b = yy / area - m.y * m.y, c = zz / area - m.z * m.z,
                 d = xy / area - m.x * m.y, e = yz / area - m.y * m.z, f = zx / area - m.z * m.x;
    const double mean = (a + b + c) / 3, p1 = d * d + e * e + f * f;
    const double spread = (a - mean) * (a - mean) + (b - mean) * (b - mean) + (c - mean) * (c - mean) + 2 * p1;
    const double p = std::sqrt(spread / 6);
    if (!(p > 0)) return std::max(mean, 0.0);
    const double x = (a - mean) / p, y = (b - mean) / p, z = (c - mean) / p, u = d / p, v = e / p, w = f / p;
    const double half_determinant = 0.5 * (x * (y * z - v * v) - u * (u * z - v * w) + w * (u * v - y * w));
    const double angle = std::acos(std::clamp(half_determinant, -1.0, 1.0)) / 3;
    return std::max(mean + 2 * p * std::cos(angle + 2 * pi / 3), 0.0);
  }
};

std::int64_t column(double x, double width) { return static_cast<std::int64_t>(std::floor(x / width)); }

std::array<std::int64_t, 4> cell_of(Index patch, const Vec3& p, double width) {
  return {static_cast<std::int64_t>(patch), column(p.x, width), column(p.y, width), column(p.z, width)};
}

}  // namespace

FlatExtent::Level& FlatExtent::level(unsigned number) {
  while (levels_.size() <= number) {
    Level& made = levels_.emplace_back();
    made.cell = std::ldexp(widest_, -static_cast<int>(levels_.size() - 1)) / 3;
    for (Index f = 0; f < faces_.size(); ++f) {
      const auto& [a, b, c] = faces_[f].corners;
      made.entries.push_back({cell_of(faces_[f].patch, (1.0 / 3) * (a + b + c), made.cell), f});
    }
    std::sort(made.entries.begin(), made.entries.end(),
              [](const Entry& x, const Entry& y) { return x.cell != y.cell ? x.cell < y.cell : x.face < y.face; });
    made.off.assign(made.entries.size(), -1);
  }
  return levels_[number];
}

double FlatExtent::measure(const Level& level, const std::array<std::int64_t, 4>& middle, const Vec3& place) const {
  Moments moments;
  for (std::int64_t i = middle[1] - 1; i <= middle[1] + 1; ++i)
    for (std::int64_t j = middle[2] - 1; j <= middle[2] + 1; ++j) {
      const std::array<std::int64_t, 4> first{middle[0], i, j, middle[3] - 1}, last{middle[0], i, j, middle[3] + 1};
      auto at = std::lower_bound(level.entries.begin(), level.entries.end(), first,
                                 [](const Entry& e, const auto& cell) { return e.cell < cell; });
      for (; at != level.entries.end() && at->cell <= last; ++at) {
        const auto& [a, b, c] = faces_[at->face].corners;
        moments.add(a - place, b - place, c - place);
      }
    }
  return std::sqrt(moments.off_plane_squared());
}

double FlatExtent::off_plane(Level& level, Index patch, const Vec3& place) {
  const auto cell = cell_of(patch, place, level.cell);
  const auto first = std::lower_bound(level.entries.begin(), level.entries.end(), cell,
                                      [](const Entry& e, const auto& c) { return e.cell < c; });
  const bool is_known = first != level.entries.end() && first->cell == cell;
  if (!is_known) return measure(level, cell, place);
  double& off = level.off[static_cast<std::size_t>(first - level.entries.begin())];
  if (off < 0) off = measure(level, cell, place);
  return off;
}

double FlatExtent::at(Index patch, const Vec3& place, double least, double tolerance) {
  double width = widest_;
  for (unsigned k = 0; k < most_levels && width > least; ++k, width *= 0.5)
    if (off_plane(level(k), patch, place) <= share_of_tolerance * tolerance) return width;
  return 0;
}

}  // namespace geomesh::remesh
