// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/triangles/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel {
namespace {

bool in_triangle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
  return orient2d(a, b, p) != Sign::negative && orient2d(b, c, p) != Sign::negative &&
         orient2d(c, a, p) != Sign::negative;
}

/// Returns whether corner `i` of a polygon can be cut off: it is strictly convex, and the triangle with its neighbours
/// (the ear) contains no other remaining corner.
bool is_ear(const std::vector<Vec2>& corner, const std::vector<std::size_t>& left, std::size_t i) {
  const std::size_t n = left.size();
  const Vec2 &a = corner[left[(i + n - 1) % n]], &b = corner[left[i]], &c = corner[left[(i + 1) % n]];
  if (orient2d(a, b, c) != Sign::positive) return false;
  for (std::size_t k = 2; k + 1 < n; ++k) {
    const Vec2& p = corner[left[(i + k) % n]];
    if (p == a || p == b || p == c) continue;
    if (in_triangle(a, b, c, p)) return false;
  }
  return true;
}

}  // namespace

PlaneProjection::PlaneProjection(std::span<const Vec3> polygon) {
  Vec3 area;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    area = area + cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  const double ax = std::abs(area.x), ay = std::abs(area.y), az = std::abs(area.z);
  const std::size_t drop = az >= ax && az >= ay ? 2 : ax >= ay ? 0 : 1;
  axis[0] = (drop + 1) % 3;
  axis[1] = (drop + 2) % 3;
  if (area[drop] < 0) std::swap(axis[0], axis[1]);
}

std::vector<Triangle> triangulate_polygon(std::span<const Vec3> points, std::span<const VertexIndex> loop) {
  std::vector<Vec3> polygon;
  for (const VertexIndex v : loop) polygon.push_back(points[v]);
  const PlaneProjection project(polygon);
  std::vector<Vec2> corner;
  for (const Vec3& p : polygon) corner.push_back(project(p));
  std::vector<std::size_t> left(loop.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  std::vector<Triangle> triangles;
  while (left.size() >= 3) {
    const std::size_t n = left.size();
    std::size_t i = 0;
    while (i < n && !is_ear(corner, left, i)) ++i;
    if (i == n) return {};
    triangles.push_back({loop[left[(i + n - 1) % n]], loop[left[i]], loop[left[(i + 1) % n]]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return triangles;
}

bool append_polygon(std::span<const Vec3> points, std::span<const VertexIndex> loop, std::vector<Triangle>& triangles) {
  if (loop.size() == 3) {
    triangles.push_back({loop[0], loop[1], loop[2]});
    return true;
  }
  const std::vector<Triangle> pieces = triangulate_polygon(points, loop);
  triangles.insert(triangles.end(), pieces.begin(), pieces.end());
  return !pieces.empty();
}

int side_of_polygon(std::span<const Vec2> polygon, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 &a = polygon[j], &b = polygon[i];
    const Sign turn = orient2d(a, b, p);
    if (turn == Sign::zero && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
        p.y <= std::max(a.y, b.y)) {
      return 0;
    }
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    if ((turn == Sign::positive) == (a.y < b.y)) inside = !inside;
  }
  return inside ? 1 : -1;
}

}  // namespace geomesh::geomodel
