// SPDX-License-Identifier: GPL-3.0-or-later
#include "fractures/fracture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace geomesh::geomodel {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Returns the part of a polygon in which sign * p[axis] <= sign * limit (Sutherland and Hodgman 1974).
std::vector<Vec3> clipped_at(const std::vector<Vec3>& polygon, std::size_t axis, double limit, double sign) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double beyond_a = sign * (a[axis] - limit), beyond_b = sign * (b[axis] - limit);
    if (beyond_a <= 0) kept.push_back(a);
    if ((beyond_a < 0 && beyond_b > 0) || (beyond_a > 0 && beyond_b < 0))
      kept.push_back(a + (beyond_a / (beyond_a - beyond_b)) * (b - a));
  }
  return kept;
}

Vec3 mean_of(const std::vector<Vec3>& points) {
  Vec3 sum;
  for (const Vec3& p : points) sum = sum + p;
  return (1 / static_cast<double>(points.size())) * sum;
}

/// Returns Newell's normal of a polygon, which is that of the mean plane; its length is twice the area.
Vec3 normal_of(const std::vector<Vec3>& polygon) {
  const Vec3 center = mean_of(polygon);
  Vec3 sum;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum = sum + cross(polygon[i] - center, polygon[(i + 1) % polygon.size()] - center);
  return sum;
}

}  // namespace

std::string plane_fault(const std::vector<Vec3>& corners) {
  const Vec3 normal = normal_of(corners), center = mean_of(corners);
  const double area2 = std::sqrt(dot(normal, normal));
  double size = 0, off = 0;
  for (const Vec3& p : corners) {
    size = std::max(size, std::sqrt(dot(p - center, p - center)));
    off = std::max(off, area2 > 0 ? std::abs(dot(normal, p - center)) / area2 : 0);
  }
  if (!(area2 > 1e-12 * size * size)) return "the corners of the polygon lie on a line";
  if (off <= plane_share * size) return "";
  char text[200];
  std::snprintf(text, sizeof text,
                "the polygon is not plane: a corner is %.4g off the mean plane, near (%.9g, %.9g, %.9g); give its "
                "corners in one plane, or divide it into triangles",
                off, center.x, center.y, center.z);
  return text;
}

std::vector<Vec3> polygon_of(const Ellipse& ellipse, int n_corners, PolygonSize size) {
  const double step = 2 * std::numbers::pi / n_corners;
  const double scale = size == PolygonSize::inscribed ? 1 : std::sqrt(step / std::sin(step));
  std::vector<Vec3> corners;
  for (int i = 0; i < n_corners; ++i)
    corners.push_back(ellipse.center + (scale * ellipse.major * std::cos(i * step)) * ellipse.x_axis +
                      (scale * ellipse.minor * std::sin(i * step)) * ellipse.y_axis);
  return corners;
}

PlaneAxes axes_of_plane(double dip_direction, double dip) {
  const double azimuth = dip_direction * degree, slope = dip * degree;
  return {{-std::cos(azimuth), std::sin(azimuth), 0},
          {std::sin(azimuth) * std::cos(slope), std::cos(azimuth) * std::cos(slope), -std::sin(slope)}};
}

double area_of(const std::vector<Vec3>& polygon) {
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum = sum + cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return 0.5 * std::sqrt(dot(sum, sum));
}

std::vector<Vec3> clipped(std::vector<Vec3> polygon, const Box3& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    polygon = clipped_at(polygon, axis, box.max[axis], 1);
    polygon = clipped_at(polygon, axis, box.min[axis], -1);
  }
  return polygon;
}

}  // namespace geomesh::geomodel
