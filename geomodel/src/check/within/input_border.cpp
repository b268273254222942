// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/within/input_border.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

namespace geomesh::geomodel::checking {

std::vector<Triangle> welded(const TriangulatedSurface& surface) {
  const auto less = [&](VertexIndex a, VertexIndex b) {
    const Vec3 &p = surface.points[a], &q = surface.points[b];
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  };
  std::set<VertexIndex, decltype(less)> first(less);
  std::vector<Triangle> triangles;
  for (const Triangle& t : surface.triangles) {
    Triangle w{};
    for (std::size_t i = 0; i < 3; ++i) w[i] = *first.insert(t[i]).first;
    if (w[0] != w[1] && w[1] != w[2] && w[2] != w[0]) triangles.push_back(w);
  }
  return triangles;
}

namespace {

std::vector<Corners> corners_of(const TriangulatedSurface& surface, const std::vector<Triangle>& triangles) {
  std::vector<Corners> corners;
  for (const Triangle& t : triangles)
    corners.push_back({surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]});
  return corners;
}

/// Returns for each vertex the smallest index among the vertices of its connected piece, joined by triangles.
std::vector<VertexIndex> pieces_of(const std::vector<Triangle>& triangles, std::size_t n_points) {
  std::vector<VertexIndex> root(n_points);
  std::iota(root.begin(), root.end(), VertexIndex{0});
  const auto find = [&](VertexIndex v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (const Triangle& t : triangles)
    for (std::size_t i = 1; i < 3; ++i) {
      const auto [least, other] = std::minmax({find(t[0]), find(t[i])});
      root[other] = least;
    }
  for (VertexIndex v = 0; v < n_points; ++v) root[v] = find(v);
  return root;
}

}  // namespace

InputBorder::InputBorder(const TriangulatedSurface& surface, const Allowed& allowed)
    : set_(std::vector<Corners>{}), triangles_(std::vector<Corners>{}), length_(allowed.both()) {
  std::map<std::array<VertexIndex, 2>, std::size_t> count;
  const std::vector<Triangle> triangles = welded(surface);
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) ++count[{std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])}];
  const std::vector<VertexIndex> pieces = pieces_of(triangles, surface.points.size());
  for (const Triangle& t : triangles) piece_of_triangle_.push_back(pieces[t[0]]);
  triangles_ = TriangleSet(corners_of(surface, triangles));
  const TriangleSet all(triangles_of(surface));
  for (const auto& [e, n] : count) {
    if (n != 1) continue;
    const Vec3 &a = surface.points[e[0]], &b = surface.points[e[1]];
    for (const VertexIndex v : e) at_[v].push_back(static_cast<Index>(edges_.size()));
    edges_.push_back({a, b, b});
    ends_.push_back(e);
    piece_of_edge_.push_back(pieces[e[0]]);
    cracks_.push_back(all.near(0.5 * (a + b), allowed.rounding).size() > 1);
  }
  set_ = TriangleSet(edges_);
}

bool InputBorder::faces_border(Index row, const Vec3& p) const {
  const auto distance_to = [&](const Vec3& q) { return std::sqrt(dot(q - p, q - p)); };
  const std::vector<TriangleSet::Near> near = set_.near(p, length_);
  const auto length = [&](Index e) {
    const Vec3 d = edges_[e][1] - edges_[e][0];
    return std::sqrt(dot(d, d));
  };
  std::map<VertexIndex, double> along;  // shortest known distance from p along the border to each vertex
  std::vector<std::pair<VertexIndex, double>> open;
  for (std::size_t k = 0; k < 2; ++k) open.emplace_back(ends_[row][k], distance_to(edges_[row][k]));
  while (!open.empty()) {
    const auto [v, distance] = open.back();
    open.pop_back();
    if (distance > 2 * length_) continue;
    const auto known = along.find(v);
    if (known != along.end() && known->second <= distance) continue;
    along[v] = distance;
    for (const Index e : at_.at(v))
      open.emplace_back(ends_[e][0] == v ? ends_[e][1] : ends_[e][0], distance + length(e));
  }
  const auto is_reached = [&](Index e) {
    const Vec3 q = nearest_on_triangle(p, edges_[e]);
    for (std::size_t k = 0; k < 2; ++k) {
      const auto at = along.find(ends_[e][k]);
      const Vec3 d = q - edges_[e][k];
      if (at != along.end() && at->second + std::sqrt(dot(d, d)) <= 2 * length_) return true;
    }
    return e == row;
  };
  return std::any_of(near.begin(), near.end(), [&](const TriangleSet::Near& n) { return !is_reached(n.triangle); });
}

bool InputBorder::faces_other_piece(Index row, const Vec3& p) const {
  const std::vector<TriangleSet::Near> near = triangles_.near(p, length_);
  return std::any_of(near.begin(), near.end(),
                     [&](const TriangleSet::Near& n) { return piece_of_triangle_[n.triangle] != piece_of_edge_[row]; });
}

}  // namespace geomesh::geomodel::checking
