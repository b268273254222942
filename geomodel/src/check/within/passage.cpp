// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/within/passage.hpp"

#include <algorithm>
#include <cmath>

#include "check/exact/exact.hpp"
#include "check/within/input_border.hpp"

namespace geomesh::geomodel::checking {
namespace {

std::vector<Corners> corners_of(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
  std::vector<Corners> corners;
  for (const Triangle& t : triangles) corners.push_back({points[t[0]], points[t[1]], points[t[2]]});
  return corners;
}

BoxTree tree_of(const std::vector<Corners>& triangles) {
  std::vector<Box3> boxes;
  for (const Corners& t : triangles) boxes.push_back(box_of(t[0], t[1], t[2]));
  return BoxTree(std::move(boxes));
}

/// Returns the point at which the edge p q passes through the inside of the triangle; nothing if it touches the
/// triangle's border or lies in its plane. Decided exactly.
std::optional<Vec3> piercing(const Vec3& p, const Vec3& q, const Corners& t) {
  const Sign above = orientation(t[0], t[1], t[2], p), below = orientation(t[0], t[1], t[2], q);
  if (above == Sign::zero || below == Sign::zero || above == below) return std::nullopt;
  const Sign turn = orientation(p, q, t[0], t[1]);
  if (turn == Sign::zero || orientation(p, q, t[1], t[2]) != turn || orientation(p, q, t[2], t[0]) != turn)
    return std::nullopt;
  const double a = std::abs(six_volumes(t[0], t[1], t[2], p)), b = std::abs(six_volumes(t[0], t[1], t[2], q));
  return p + (a / (a + b)) * (q - p);
}

double length(const Vec3& d) { return std::sqrt(dot(d, d)); }

/// Returns the polyline up to and including its first point that is deeper than `depth`, that is, farther from the
/// other surface; nothing if the polyline ends before.
std::optional<std::vector<Vec3>> until_deeper(const Vec3& start, const std::vector<Vec3>& line,
                                              const FollowedSurface& other, double depth, const AlongLine& along) {
  constexpr double least_step = 0.25;  // of the depth
  std::vector<Vec3> passed;
  Vec3 from = start;
  for (const Vec3& to : line) {
    const double l = length(to - from);
    for (double at = 0; at < l;) {
      const Vec3 p = from + (at / l) * (to - from);
      double distance = depth;
      const auto near = other.set().near(p, depth);
      if (near.empty()) {
        passed.push_back(p);
        return passed;
      }
      if (along.ends(p)) return std::nullopt;
      along.visit(p);
      for (const TriangleSet::Near& n : near) distance = std::min(distance, n.distance);
      at += std::clamp(depth - distance, 0.01 * depth, least_step * depth);
    }
    passed.push_back(from = to);
  }
  return std::nullopt;
}

bool passes_odd_times(const std::vector<Vec3>& line, const FollowedSurface& surface) {
  std::size_t n = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    surface.tree().query(box_of(line[i - 1], line[i], line[i]),
                         [&](Index t) { n += piercing(line[i - 1], line[i], surface.triangles()[t]).has_value(); });
  return n % 2 == 1;
}

}  // namespace

std::optional<std::array<Vec3, 2>> crossing_of(const Corners& s, const Corners& t) {
  std::vector<Vec3> ends;
  for (std::size_t k = 0; k < 3; ++k) {
    if (const auto p = piercing(s[k], s[(k + 1) % 3], t)) ends.push_back(*p);
    if (const auto p = piercing(t[k], t[(k + 1) % 3], s)) ends.push_back(*p);
  }
  if (ends.size() != 2) return std::nullopt;
  return std::array{ends[0], ends[1]};
}

FollowedSurface::FollowedSurface(const TriangulatedSurface& surface)
    : points_(surface.points),
      triangles_(welded(surface)),
      corners_(corners_of(points_, triangles_)),
      tree_(tree_of(corners_)),
      set_(corners_) {
  for (Index t = 0; t < triangles_.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexIndex a = triangles_[t][i], b = triangles_[t][(i + 1) % 3];
      at_[{std::min(a, b), std::max(a, b)}].push_back(t);
    }
}

Vec3 FollowedSurface::cut(const Edge& edge, const CurvePlane& plane) const {
  const double a = height(edge[0], plane), b = height(edge[1], plane);
  return points_[edge[0]] + (a / (a - b)) * (points_[edge[1]] - points_[edge[0]]);
}

std::optional<FollowedSurface::Edge> FollowedSurface::exit(Index triangle, const CurvePlane& plane,
                                                           const Edge& entered) const {
  const Triangle& t = triangles_[triangle];
  for (std::size_t i = 0; i < 3; ++i) {
    const Edge e{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])};
    if (e != entered && (height(e[0], plane) >= 0) != (height(e[1], plane) >= 0)) return e;
  }
  return std::nullopt;
}

std::vector<std::vector<Vec3>> FollowedSurface::lines(Index triangle, const CurvePlane& plane) const {
  std::vector<std::vector<Vec3>> lines;
  constexpr Edge none{no_vertex, no_vertex};
  const auto first = exit(triangle, plane, none);
  const auto second = first ? exit(triangle, plane, *first) : std::nullopt;
  if (!second) return lines;
  for (Edge edge : {*first, *second}) {
    std::vector<Vec3>& line = lines.emplace_back();
    for (Index t = triangle;;) {
      line.push_back(cut(edge, plane));
      const std::vector<Index>& at = at_.at(edge);
      if (at.size() != 2) break;
      t = at[0] == t ? at[1] : at[0];
      const auto next = exit(t, plane, edge);
      if (t == triangle || !next) break;
      edge = *next;
    }
  }
  return lines;
}

bool passes_through(const FollowedSurface& surface, Index triangle, const CurvePlane& plane,
                    const FollowedSurface& other, double depth, const AlongLine& along) {
  std::vector<Vec3> whole;
  for (const std::vector<Vec3>& line : surface.lines(triangle, plane)) {
    const auto part = until_deeper(plane.place, line, other, depth, along);
    if (!part) return false;
    std::reverse(whole.begin(), whole.end());
    whole.insert(whole.end(), part->begin(), part->end());
  }
  return whole.size() > 1 && passes_odd_times(whole, other);
}

}  // namespace geomesh::geomodel::checking
