// SPDX-License-Identifier: MIT
#include "search/closest_point.hpp"

#include <algorithm>
#include <cmath>

namespace geomesh::search {

Vec3 closest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double dd = dot(d, d);
  return dd > 0 ? a + std::clamp(dot(p - a, d) / dd, 0.0, 1.0) * d : a;
}

std::array<Vec3, 2> closest_on_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w), det = uu * vv - uv * uv;
  // On the first line nearest to the second (anywhere where they are parallel), then back and forth within the ends.
  const double s = det > 0 ? std::clamp((uv * vw - vv * uw) / det, 0.0, 1.0) : 0.0;
  const Vec3 q = closest_on_segment(a + s * u, c, d), p = closest_on_segment(q, a, b);
  return {p, closest_on_segment(p, c, d)};
}

Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, n = cross(ab, ac);
  if (!(dot(n, n) > 0)) {
    // Collinear corners: the nearest of the sides.
    const std::array<Vec3, 3> q{closest_on_segment(p, a, b), closest_on_segment(p, b, c), closest_on_segment(p, c, a)};
    return *std::min_element(q.begin(), q.end(),
                             [&](const Vec3& u, const Vec3& v) { return dot(u - p, u - p) < dot(v - p, v - p); });
  }
  const Vec3 ap = p - a, bp = p - b, cp = p - c;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d1 <= 0 && d2 <= 0) return a;
  if (d3 >= 0 && d4 <= d3) return b;
  if (d6 >= 0 && d5 <= d6) return c;
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + (d1 / (d1 - d3)) * ab;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + (d2 / (d2 - d6)) * ac;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
  const double w = 1 / (va + vb + vc);
  return a + (vb * w) * ab + (vc * w) * ac;
}

ClosestPointTrees::ClosestPointTrees(std::vector<Item> items, std::size_t n_groups)
    : items_(std::move(items)), roots_(n_groups, no_index) {
  std::stable_sort(items_.begin(), items_.end(), [](const Item& a, const Item& b) { return a.group < b.group; });
  for (Index i = 0; i < items_.size();) {
    Index j = i;
    while (j < items_.size() && items_[j].group == items_[i].group) ++j;
    roots_[items_[i].group] = build(i, j);
    i = j;
  }
}

Index ClosestPointTrees::build(Index first, Index last) {
  const Index n = static_cast<Index>(nodes_.size());
  Node node{{}, first, last};
  for (Index i = first; i < last; ++i)
    for (const Vec3& c : items_[i].corners) node.box.add(c);
  nodes_.push_back(node);
  if (last - first > 4) {
    const Vec3 extent = node.box.max - node.box.min;
    const std::size_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const Index middle = first + (last - first) / 2;
    const auto centre = [axis](const Item& t) { return t.corners[0][axis] + t.corners[1][axis] + t.corners[2][axis]; };
    std::nth_element(items_.begin() + first, items_.begin() + middle, items_.begin() + last,
                     [&](const Item& a, const Item& b) { return centre(a) != centre(b) ? centre(a) < centre(b) : a.id < b.id; });
    const Index left = build(first, middle);
    const Index right = build(middle, last);
    nodes_[n].left = left;
    nodes_[n].right = right;
  }
  return n;
}

ClosestPoint ClosestPointTrees::closest(const Vec3& p, Index group, double limit) const {
  ClosestPoint best;
  if (!has_group(group)) return best;
  double bound = limit * limit;
  Index stack[96];
  int top = 0;
  stack[top++] = roots_[group];
  while (top > 0) {
    const Node& n = nodes_[stack[--top]];
    if (squared_distance_to(n.box, p) > bound) continue;
    if (n.left == no_index) {
      for (Index i = n.first; i < n.last; ++i) {
        const Item& t = items_[i];
        const Vec3 q = closest_on_triangle(p, t.corners[0], t.corners[1], t.corners[2]);
        const double d = dot(q - p, q - p);
        if (d < bound || (d <= bound && best.item == no_index)) {
          bound = d;
          best = {d, q, t.id};
        }
      }
      continue;
    }
    const bool left_first = squared_distance_to(nodes_[n.left].box, p) <= squared_distance_to(nodes_[n.right].box, p);
    stack[top++] = left_first ? n.right : n.left;
    stack[top++] = left_first ? n.left : n.right;
  }
  if (best.item != no_index) best.distance = std::sqrt(best.distance);
  return best;
}

}  // namespace geomesh::search
