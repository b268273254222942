// SPDX-License-Identifier: MIT
#include "search/closest_point.hpp"

#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"

namespace geomesh::search {

Vec3 closest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double dd = dot(d, d);
  return dd > 0 ? a + std::clamp(dot(p - a, d) / dd, 0.0, 1.0) * d : a;
}

std::array<Vec3, 2> closest_on_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w), det = uu * vv - uv * uv;
  // Starts at the point of the first line that is nearest to the second line (at any point if they are parallel), then
  // projects alternately onto both segments.
  const double s = det > 0 ? std::clamp((uv * vw - vv * uw) / det, 0.0, 1.0) : 0.0;
  const Vec3 q = closest_on_segment(a + s * u, c, d), p = closest_on_segment(q, a, b);
  return {p, closest_on_segment(p, c, d)};
}

PreparedTriangle::PreparedTriangle(const std::array<Vec3, 3>& corners, double width_of_needle)
    : corners_(corners),
      ab_(corners[1] - corners[0]),
      ac_(corners[2] - corners[0]),
      abab_(dot(ab_, ab_)),
      abac_(dot(ab_, ac_)),
      acac_(dot(ac_, ac_)) {
  // Rounding turns the normal n of a triangle h times as wide as long by about 1e-16 / h radians, which moves the
  // result of barycentric coordinates by 1e-16 / h^2 of the length.
  constexpr double width_of_line = 1e-13;
  const Vec3 n = cross(ab_, ac_), bc = corners[2] - corners[1];
  const double square = dot(n, n), longest_square = std::max({abab_, acac_, dot(bc, bc)});
  const auto is_wider = [&](double width) { return square > longest_square * longest_square * (width * width); };
  has_area_ = is_wider(width_of_line);
  is_needle_ = !is_wider(width_of_needle);
  square_of_width_ = longest_square > 0 ? square / longest_square : 0;
  normal_ = unit(n);
}

Vec3 PreparedTriangle::closest_on_sides(const Vec3& p) const {
  const auto& [a, b, c] = corners_;
  if (b == c) return closest_on_segment(p, a, b);
  const std::array<Vec3, 3> q{closest_on_segment(p, a, b), closest_on_segment(p, b, c), closest_on_segment(p, c, a)};
  return *std::min_element(q.begin(), q.end(),
                           [&](const Vec3& u, const Vec3& v) { return dot(u - p, u - p) < dot(v - p, v - p); });
}

Vec3 PreparedTriangle::closest_in_needle(const Vec3& p) const {
  const Vec3 on_side = closest_on_sides(p);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& from = corners_[i];
    if (!(dot(cross(corners_[(i + 1) % 3] - from, p - from), normal_) > 0)) return on_side;
  }
  // If rounding has rotated a needle's normal, the projection is wrong for a distant p. The true nearest point is at
  // most the width of the needle away from its side.
  const Vec3 foot = p - dot(normal_, p - on_side) * normal_;
  return dot(foot - on_side, foot - on_side) <= square_of_width_ ? foot : on_side;
}

Vec3 PreparedTriangle::closest_to(const Vec3& p) const {
  if (!has_area_) return closest_on_sides(p);
  if (is_needle_) return closest_in_needle(p);
  const auto& [a, b, c] = corners_;
  const Vec3 ap = p - a;
  const double d1 = dot(ab_, ap), d2 = dot(ac_, ap), d3 = d1 - abab_, d4 = d2 - abac_, d5 = d1 - abac_, d6 = d2 - acac_;
  if (d1 <= 0 && d2 <= 0) return a;
  if (d3 >= 0 && d4 <= d3) return b;
  if (d6 >= 0 && d5 <= d6) return c;
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + (d1 / (d1 - d3)) * ab_;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + (d2 / (d2 - d6)) * ac_;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
  const double w = 1 / (va + vb + vc);
  return a + (vb * w) * ab_ + (vc * w) * ac_;
}

Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double width_of_needle = 1e-2;
  return PreparedTriangle({a, b, c}, width_of_needle).closest_to(p);
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
  prepared_.reserve(items_.size());
  for (const Item& item : items_) prepared_.emplace_back(item.corners);
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
    std::nth_element(
        items_.begin() + first, items_.begin() + middle, items_.begin() + last,
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
  struct Entry {
    Index node;
    double squared_distance;
  };
  const auto entry = [&](Index n) { return Entry{n, squared_distance_to(nodes_[n].box, p)}; };
  Entry stack[96];
  int top = 0;
  stack[top++] = entry(roots_[group]);
  while (top > 0) {
    const Entry e = stack[--top];
    if (e.squared_distance > bound) continue;
    const Node& n = nodes_[e.node];
    if (n.left == no_index) {
      for (Index i = n.first; i < n.last; ++i) {
        const Vec3 q = prepared_[i].closest_to(p);
        const double d = dot(q - p, q - p);
        if (d < bound || (d <= bound && best.item == no_index)) {
          bound = d;
          best = {d, q, items_[i].id};
        }
      }
      continue;
    }
    const Entry left = entry(n.left), right = entry(n.right);
    const bool left_first = left.squared_distance <= right.squared_distance;
    stack[top++] = left_first ? right : left;
    stack[top++] = left_first ? left : right;
  }
  if (best.item != no_index) best.distance = std::sqrt(best.distance);
  return best;
}

}  // namespace geomesh::search
