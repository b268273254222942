// SPDX-License-Identifier: MIT
#include "plc/planar_triangulation.hpp"

#include <algorithm>
#include <deque>
#include <numeric>

#include "geomesh/core/predicates.hpp"

namespace geomesh {

Sign PlanarTriangulation::orient(unsigned a, unsigned b, unsigned c) const {
  return orient2d(points_[a], points_[b], points_[c]);
}

std::optional<unsigned> PlanarTriangulation::apex(unsigned a, unsigned b) const {
  const auto it = apex_.find({a, b});
  if (it == apex_.end()) return std::nullopt;
  return it->second;
}

void PlanarTriangulation::add(unsigned a, unsigned b, unsigned c) {
  apex_[{a, b}] = c;
  apex_[{b, c}] = a;
  apex_[{c, a}] = b;
}

bool PlanarTriangulation::flippable(unsigned a, unsigned b) const {
  const auto c = apex(a, b), d = apex(b, a);
  return c && d && orient(*d, b, *c) == Sign::positive && orient(*c, a, *d) == Sign::positive;
}

void PlanarTriangulation::flip(unsigned a, unsigned b) {
  const unsigned c = *apex(a, b), d = *apex(b, a);
  apex_.erase({a, b});
  apex_.erase({b, a});
  add(d, b, c);
  add(c, a, d);
}

bool PlanarTriangulation::triangulate() {
  const unsigned n = static_cast<unsigned>(points_.size());
  std::vector<unsigned> order(n);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](unsigned a, unsigned b) {
    return points_[a].x != points_[b].x ? points_[a].x < points_[b].x : points_[a].y < points_[b].y;
  });
  for (unsigned i = 1; i < n; ++i)
    if (points_[order[i - 1]] == points_[order[i]]) return false;
  unsigned first = 2;
  while (first < n && orient(order[0], order[1], order[first]) == Sign::zero) ++first;
  if (first >= n) return false;
  // A fan over the collinear start, then each point is joined with the hull edges that it sees.
  std::vector<unsigned> next(n), previous(n);
  const auto join = [&](unsigned a, unsigned b) {
    next[a] = b;
    previous[b] = a;
  };
  const unsigned tip = order[first];
  const bool left = orient(order[0], order[1], tip) == Sign::positive;
  for (unsigned i = 0; i + 1 < first; ++i) {
    const unsigned a = left ? order[i] : order[i + 1], b = left ? order[i + 1] : order[i];
    add(a, b, tip);
    join(a, b);
  }
  join(left ? order[first - 1] : order[0], tip);
  join(tip, left ? order[0] : order[first - 1]);
  for (unsigned i = first + 1; i < n; ++i) {
    const unsigned p = order[i], last = order[i - 1];
    unsigned up = last, down = last;
    while (orient(up, next[up], p) == Sign::negative) {
      add(next[up], up, p);
      up = next[up];
    }
    while (orient(previous[down], down, p) == Sign::negative) {
      add(down, previous[down], p);
      down = previous[down];
    }
    join(down, p);
    join(p, up);
  }
  restore_delaunay();
  return true;
}

void PlanarTriangulation::restore_delaunay() {
  std::vector<Edge> queue;
  for (const auto& [edge, apex] : apex_)
    if (edge[0] < edge[1]) queue.push_back(edge);
  while (!queue.empty()) {
    const auto [a, b] = queue.back();
    queue.pop_back();
    const auto c = apex(a, b), d = apex(b, a);
    if (!c || !d || is_constraint(a, b) || !flippable(a, b) || !inside_circle_(a, b, *c, *d)) continue;
    flip(a, b);
    for (const Edge e : {Edge{a, *c}, Edge{*c, b}, Edge{b, *d}, Edge{*d, a}}) queue.push_back(e);
  }
}

std::optional<PlanarTriangulation::Obstacle> PlanarTriangulation::crossed_edges(unsigned a, unsigned b,
                                                                                std::vector<Edge>& out) const {
  // The triangle at a whose far edge r-l (r right of a-b, l left of it) the segment crosses.
  std::optional<Edge> entry;
  for (auto it = apex_.lower_bound({a, 0}); it != apex_.end() && it->first[0] == a; ++it) {
    const unsigned r = it->first[1], l = it->second;
    for (unsigned v : {r, l})
      if (orient(a, b, v) == Sign::zero && orient2d(points_[a], points_[b], points_[v]) == Sign::zero) {
        const bool ahead = (points_[v].x - points_[a].x) * (points_[b].x - points_[a].x) > 0 ||
                           (points_[v].y - points_[a].y) * (points_[b].y - points_[a].y) > 0;
        if (ahead) return Obstacle{v};
      }
    if (orient(a, b, r) == Sign::negative && orient(a, b, l) == Sign::positive && orient(a, r, b) == Sign::positive &&
        orient(l, a, b) == Sign::positive)
      entry = Edge{r, l};
  }
  if (!entry) return Obstacle{a, b};
  Edge e = *entry;
  while (true) {
    if (is_constraint(e[0], e[1])) return Obstacle{e[0], e[1]};
    out.push_back(e);
    const auto v = apex(e[1], e[0]);
    if (!v) return Obstacle{a, b};
    if (*v == b) return std::nullopt;
    const Sign side = orient(a, b, *v);
    if (side == Sign::zero) return Obstacle{*v};
    e = side == Sign::positive ? Edge{e[0], *v} : Edge{*v, e[1]};
  }
}

std::optional<PlanarTriangulation::Obstacle> PlanarTriangulation::insert_constraint(unsigned a, unsigned b) {
  if (!apex(a, b) && !apex(b, a)) {
    std::vector<Edge> crossed;
    if (auto obstacle = crossed_edges(a, b, crossed)) return obstacle;
    // Sloan 1993: crossed edges of convex quadrilaterals are flipped until none is crossed.
    std::deque<Edge> queue(crossed.begin(), crossed.end());
    while (!queue.empty()) {
      const auto [p, q] = queue.front();
      queue.pop_front();
      if (!flippable(p, q)) {
        queue.push_back({p, q});
        continue;
      }
      const unsigned c = *apex(p, q), d = *apex(q, p);
      flip(p, q);
      const bool touches = c == a || c == b || d == a || d == b;
      if (!touches && orient(a, b, c) * orient(a, b, d) == Sign::negative) queue.push_back({c, d});
    }
  }
  constraints_.insert(key(a, b));
  return std::nullopt;
}

}  // namespace geomesh
