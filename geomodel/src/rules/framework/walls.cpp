// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/framework/walls.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geomesh/core/predicates.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns whether the line through p and q meets the triangle, including its border.
bool line_meets(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Sign s0 = orient3d(p, q, a, b), s1 = orient3d(p, q, b, c), s2 = orient3d(p, q, c, a);
  const bool any_left = s0 == Sign::positive || s1 == Sign::positive || s2 == Sign::positive;
  const bool any_right = s0 == Sign::negative || s1 == Sign::negative || s2 == Sign::negative;
  return !(any_left && any_right);
}

}  // namespace

Walls::Walls(const std::vector<TriangulatedSurface>& surfaces, const std::vector<Index>& rows,
             const std::vector<TriangulatedSurface>& sides)
    : rows_(rows) {
  std::ranges::sort(rows_);
  std::vector<Box3> boxes;
  for (const TriangulatedSurface& side : sides) add(side, side_of_volume, boxes);
  for (const Index row : rows) add(surfaces[row], row, boxes);
  if (!boxes.empty()) tree_ = std::make_unique<arrangement::BoxTree>(boxes);
}

void Walls::add(const TriangulatedSurface& s, Index row, std::vector<Box3>& boxes) {
  for (const Triangle& t : s.triangles) {
    triangles_.push_back({s.points[t[0]], s.points[t[1]], s.points[t[2]], row});
    Box3& box = boxes.emplace_back();
    for (const VertexIndex v : t) box.add(s.points[v]);
  }
}

template <class F>
void Walls::for_each_hit(const Vec3& a, const Vec3& b, F&& visit) const {
  if (!tree_ || a == b) return;
  Box3 way;
  way.add(a);
  way.add(b);
  tree_->boxes_meeting(way, [&](Index k) {
    const Wall& wall = triangles_[k];
    const Sign from = orient3d(wall.a, wall.b, wall.c, a), to = orient3d(wall.a, wall.b, wall.c, b);
    if (from == to || from == Sign::zero || !line_meets(a, b, wall.a, wall.b, wall.c)) return;
    const Vec3 normal = cross(wall.b - wall.a, wall.c - wall.a);
    const double d = dot(a - wall.a, normal), e = dot(b - wall.a, normal);
    visit(Hit{wall.surface, from == Sign::positive, d == e ? 0 : std::clamp(d / (d - e), 0.0, 1.0)});
  });
}

namespace {

/// Keeps the surface that a segment meets first; of several at one place, the one with the lowest index.
void keep_first(std::optional<Walls::Hit>& first, const Walls::Hit& hit) {
  if (!first || hit.share < first->share || (hit.share == first->share && hit.surface < first->surface)) first = hit;
}

}  // namespace

std::optional<Walls::Hit> Walls::first_hit(const Vec3& a, const Vec3& b, Index but_not) const {
  std::optional<Hit> first;
  for_each_hit(a, b, [&](const Hit& hit) {
    if (hit.surface == side_of_volume || hit.surface != but_not) keep_first(first, hit);
  });
  return first;
}

std::optional<Walls::Hit> Walls::first_surface(const Vec3& a, const Vec3& b, Index but_not) const {
  std::optional<Hit> first;
  for_each_hit(a, b, [&](const Hit& hit) {
    if (hit.surface != side_of_volume && hit.surface != but_not) keep_first(first, hit);
  });
  return first;
}

std::array<Vec3, 4> Walls::lines_of_disc(double radius, const Vec2& slope) {
  std::array<Vec3, 4> lines;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const double angle = std::numbers::pi * static_cast<double>(k) / static_cast<double>(lines.size());
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    lines[k] = {x, y, slope.x * x + slope.y * y};
  }
  return lines;
}

bool Walls::meets_disc(const Vec3& centre, double radius, const Vec2& slope, Index but_not) const {
  return std::ranges::any_of(lines_of_disc(radius, slope), [&](const Vec3& way) {
    return first_hit(centre - way, centre + way, but_not).has_value();
  });
}

std::vector<Index> Walls::surfaces_on(const Vec3& a, const Vec3& b) const {
  std::vector<Index> found;
  for_each_hit(a, b, [&](const Hit& hit) {
    if (hit.surface != side_of_volume) found.push_back(hit.surface);
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace geomesh::geomodel
