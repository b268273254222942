// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/clip/body_shape.hpp"

#include <algorithm>

namespace geomesh::geomodel::arrangement {
namespace {

struct DirectedEdge {
  VertexIndex a, b;  ///< a < b
  Index triangle;
  int direction;
  bool operator<(const DirectedEdge& o) const { return std::tie(a, b, triangle) < std::tie(o.a, o.b, o.triangle); }
};

std::vector<DirectedEdge> edges_of(const std::vector<Triangle>& triangles) {
  std::vector<DirectedEdge> edges;
  for (Index t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const VertexIndex a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      if (a == b) continue;
      edges.push_back(a < b ? DirectedEdge{a, b, t, 1} : DirectedEdge{b, a, t, -1});
    }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Calls visit(begin, end) for each run of sorted directed edges that have the same two ends.
template <typename Visit>
void for_each_edge(const std::vector<DirectedEdge>& edges, Visit&& visit) {
  for (std::size_t begin = 0, end; begin < edges.size(); begin = end) {
    for (end = begin + 1; end < edges.size() && edges[end].a == edges[begin].a && edges[end].b == edges[begin].b;)
      ++end;
    visit(begin, end);
  }
}

struct Border {
  double length = 0;
  Box3 box;
  Vec3 place;
};

/// Returns the boundary of the oriented triangles as a chain: edges whose directions do not cancel.
Border border_of(const Complex& complex, const std::vector<Triangle>& triangles) {
  Border border;
  const std::vector<DirectedEdge> edges = edges_of(triangles);
  for_each_edge(edges, [&](std::size_t begin, std::size_t end) {
    int sum = 0;
    for (std::size_t e = begin; e < end; ++e) sum += edges[e].direction;
    if (sum == 0) return;
    const Vec3 &a = complex.points[edges[begin].a], &b = complex.points[edges[begin].b];
    if (border.length == 0) border.place = 0.5 * (a + b);
    border.length += length(a - b);
    border.box.add(a);
    border.box.add(b);
  });
  return border;
}

/// Flips triangles so that neighbours across edges with two triangles are consistently oriented.
void orient_consistently(std::vector<Triangle>& triangles, std::vector<std::int8_t>& orientation) {
  const std::vector<DirectedEdge> edges = edges_of(triangles);
  std::vector<std::vector<std::pair<Index, int>>> neighbours(triangles.size());
  for_each_edge(edges, [&](std::size_t begin, std::size_t end) {
    if (end - begin != 2) return;
    const int agree = edges[begin].direction != edges[begin + 1].direction ? 1 : -1;
    neighbours[edges[begin].triangle].emplace_back(edges[begin + 1].triangle, agree);
    neighbours[edges[begin + 1].triangle].emplace_back(edges[begin].triangle, agree);
  });
  std::vector<std::int8_t> turn(triangles.size(), 0);
  for (Index seed = 0; seed < triangles.size(); ++seed) {
    if (turn[seed] != 0) continue;
    turn[seed] = 1;
    std::vector<Index> stack{seed};
    while (!stack.empty()) {
      const Index t = stack.back();
      stack.pop_back();
      for (const auto& [n, agree] : neighbours[t])
        if (turn[n] == 0) {
          turn[n] = static_cast<std::int8_t>(turn[t] * agree);
          stack.push_back(n);
        }
    }
  }
  for (Index t = 0; t < triangles.size(); ++t)
    if (turn[t] < 0) {
      std::swap(triangles[t][1], triangles[t][2]);
      orientation[t] = static_cast<std::int8_t>(-orientation[t]);
    }
}

std::optional<RayDirection> away_from(const Border& border, const Box3& box) {
  for (const std::size_t axis : {2, 0, 1}) {
    if (border.box.max[axis] <= box.min[axis]) return RayDirection{axis, true};
    if (border.box.min[axis] >= box.max[axis]) return RayDirection{axis, false};
  }
  return std::nullopt;
}

}  // namespace

BodyShape body_shape(const Complex& complex, const Ingested& ingested, const SurfaceList& surfaces, Index surface,
                     const std::optional<Box3>& box) {
  BodyShape shape;
  shape.surface = surface;
  for (const Triangle& t : surfaces[surface].triangles) {
    const auto& vertex = ingested.vertex_of_point[surface];
    shape.triangles.push_back({vertex[t[0]], vertex[t[1]], vertex[t[2]]});
  }
  shape.orientation.assign(shape.triangles.size(), 1);
  Border border = border_of(complex, shape.triangles);
  if (border.length > 0) {
    std::vector<Triangle> turned = shape.triangles;
    std::vector<std::int8_t> orientation = shape.orientation;
    orient_consistently(turned, orientation);
    const Border better = border_of(complex, turned);
    if (better.length < border.length) {
      shape.triangles = std::move(turned);
      shape.orientation = std::move(orientation);
      border = better;
    }
  }
  shape.closed = border.length == 0;
  shape.border_length = border.length;
  shape.border_place = border.place;
  if (!shape.closed && box) shape.open_direction = away_from(border, *box);
  return shape;
}

}  // namespace geomesh::geomodel::arrangement
