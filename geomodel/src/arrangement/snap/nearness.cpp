// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/snap/nearness.hpp"

#include <algorithm>
#include <cmath>

#include "arrangement/model/complex.hpp"

namespace geomesh::geomodel::arrangement {

/// Solves repeatedly for the nearest points of two edges, since the first solution has large errors if the edges are
/// nearly parallel. The vector between the points found is short, so solving again for it reduces the error.
std::optional<std::array<Vec3, 2>> nearest_of_edges(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  constexpr double least_sine2 = 1e-12;
  constexpr unsigned n_corrections = 2;
  const Vec3 u = b - a, v = d - c;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), determinant = uu * vv - uv * uv;
  if (!(determinant > least_sine2 * uu * vv)) return std::nullopt;
  double s = 0, t = 0;
  Vec3 p = a, q = c;
  for (unsigned k = 0; k <= n_corrections; ++k) {
    const Vec3 between = p - q;
    s += (uv * dot(v, between) - vv * dot(u, between)) / determinant;
    t += (uu * dot(v, between) - uv * dot(u, between)) / determinant;
    p = a + s * u;
    q = c + t * v;
  }
  if (!(s > 0 && s < 1 && t > 0 && t < 1)) return std::nullopt;
  return std::array{p, q};
}

PlaneWithin::PlaneWithin(const std::array<Vec3, 3>& triangle, double distance) : at_(triangle[0]) {
  constexpr double rounding = 0x1p-50;
  const Vec3 u = triangle[1] - at_, v = triangle[2] - at_;
  normal_ = cross(u, v);
  distance_ = distance * length(normal_);
  error_ = rounding * length(u) * length(v);
}

int PlaneWithin::side(const Vec3& p) const {
  const Vec3 off = p - at_;
  const double height = dot(normal_, off);
  if (std::fabs(height) < distance_ + error_ * length(off)) return 0;
  return height > 0 ? 1 : -1;
}

/// Measures lengths perpendicular to the longest edge, in which direction a thin triangle is short, and errors are
/// small.
bool is_near_inside(const Vec3& p, const std::array<Vec3, 3>& triangle, double distance) {
  std::array<std::size_t, 3> from{0, 1, 2};  // the triangle's edges, each identified by its first corner
  const auto edge = [&](std::size_t k) { return triangle[(k + 1) % 3] - triangle[k]; };
  const std::size_t k = *std::max_element(from.begin(), from.end(), [&](std::size_t i, std::size_t j) {
    return dot(edge(i), edge(i)) < dot(edge(j), edge(j));
  });
  const Vec3 &a = triangle[k], &c = triangle[(k + 2) % 3];
  const double longest = length(edge(k));
  if (!(longest > 0)) return false;
  const Vec3 along = (1 / longest) * edge(k);
  const double c_along = dot(c - a, along), p_along = dot(p - a, along);
  const Vec3 to_c = (c - a) - c_along * along, to_p = (p - a) - p_along * along;
  const double height = length(to_c);
  if (!(height > 0)) return false;
  const Vec3 across = (1 / height) * to_c;
  const double p_across = dot(to_p, across);
  if (!(length(to_p - p_across * across) < distance)) return false;
  return p_across > 0 && p_across * c_along < height * p_along &&
         p_across * (longest - c_along) < height * (longest - p_along);
}

}  // namespace geomesh::geomodel::arrangement
