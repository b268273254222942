// SPDX-License-Identifier: MIT
#include "search/sheet_proof.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "common/geometry.hpp"

namespace geomesh::search {

namespace {

/// cosine of the largest angle between two triangles that continue each other smoothly at an edge
constexpr double smooth_cosine = 0.82;
/// Cosine of the largest angle between the surface and the triangle F, 53 degrees. Two adjacent triangles near opposite
/// normals of F would be inclined to each other by so much that their common edge would be open.
constexpr double steep_cosine = 0.6;
/// points within this share of the longest edge of the triangle F to be proven from a side of F count as on the side
constexpr double on_side = 1e-9;

struct EdgeUse {
  Index group;
  Vec3 a, b;
  Index item;
  unsigned k;
  auto key() const { return std::tuple(group, a.x, a.y, a.z, b.x, b.y, b.z); }
};

bool go_on_smoothly(const EdgeUse& x, const EdgeUse& y, std::span<const ClosestPointTrees::Item> items) {
  const auto normal = [&](const EdgeUse& e) {
    return unit(cross(e.b - e.a, items[e.item].corners[(e.k + 2) % 3] - e.a));
  };
  return dot(normal(x), normal(y)) <= -smooth_cosine;  // smooth: the two triangles lie on opposite sides of their edge
}

}  // namespace

std::vector<std::uint8_t> find_open_edges(std::span<const ClosestPointTrees::Item> items) {
  std::vector<EdgeUse> uses;
  for (Index i = 0; i < items.size(); ++i)
    for (unsigned k = 0; k < 3; ++k) {
      EdgeUse use{items[i].group, items[i].corners[k], items[i].corners[(k + 1) % 3], i, k};
      if (std::tuple(use.b.x, use.b.y, use.b.z) < std::tuple(use.a.x, use.a.y, use.a.z)) std::swap(use.a, use.b);
      uses.push_back(use);
    }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& x, const EdgeUse& y) {
    return x.key() != y.key() ? x.key() < y.key() : x.item < y.item;
  });
  std::vector<std::uint8_t> open(items.size(), 7);
  for (std::size_t i = 0, j; i < uses.size(); i = j) {
    for (j = i; j < uses.size() && uses[j].key() == uses[i].key();) ++j;
    if (j - i != 2 || !go_on_smoothly(uses[i], uses[i + 1], items)) continue;
    for (const EdgeUse& use : {uses[i], uses[i + 1]}) open[use.item] &= static_cast<std::uint8_t>(~(1u << use.k));
  }
  return open;
}

SheetProof::SheetProof(const std::array<Vec3, 3>& triangle, double limit) : corners_(triangle) {
  const Vec3 n = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  normal_ = unit(n);
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 edge = triangle[(k + 1) % 3] - triangle[k];
    longest = std::max(longest, dot(edge, edge));
    inward_[k] = unit(cross(normal_, edge));
  }
  tiny_ = on_side * std::sqrt(longest);
  limit_ = limit - 4 * tiny_;
  is_possible_ = length(n) > 1e-6 * longest && limit_ > 0;
}

bool SheetProof::is_beside(const std::array<Vec3, 3>& t, std::array<Point, most_corners>& part) const {
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 3; ++i) part[i].inside[k] = dot(t[i] - corners_[k], inward_[k]);
    if (part[0].inside[k] < -tiny_ && part[1].inside[k] < -tiny_ && part[2].inside[k] < -tiny_) return true;
  }
  return false;
}

/// Returns whether the segment p-q, projected to triangle F, is partly inside F by more than rounding errors.
bool SheetProof::has_within(const Point& p, const Point& q) const {
  double first = 0, last = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double s = p.inside[k] - tiny_, t = q.inside[k] - tiny_;
    if (s <= 0 && t <= 0) return false;
    if (s < 0) first = std::max(first, s / (s - t));
    if (t < 0) last = std::min(last, s / (s - t));
  }
  return first < last;
}

Over SheetProof::judge(const SheetTriangle& t) {
  const auto& corners = t.triangle->corners();
  // The surface's triangle is cut at the sides of F, from one array into the other, down to its part over F.
  std::array<std::array<Point, most_corners>, 2> parts;
  if (is_beside(corners, parts[0])) return Over::nothing;
  for (std::size_t i = 0; i < 3; ++i) parts[0][i].height = dot(corners[i] - corners_[0], normal_);
  for (unsigned k = 0; k < 3; ++k)
    if ((t.open_edges >> k & 1u) != 0 && has_within(parts[0][k], parts[0][(k + 1) % 3])) return Over::border;
  std::size_t n = 3, now = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& part = parts[now];
    auto& rest = parts[1 - now];
    const auto is_inside = [&](const Point& p) { return p.inside[k] + tiny_ >= 0; };
    if (std::all_of(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(n), is_inside)) continue;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Point &p = part[i], &q = part[(i + 1) % n];
      const double s = p.inside[k] + tiny_, u = q.inside[k] + tiny_;
      if (s >= 0) rest[kept++] = p;
      if ((s < 0) == (u < 0)) continue;
      const double along = s / (s - u);
      Point& cut = rest[kept++];
      for (std::size_t j = 0; j < 3; ++j) cut.inside[j] = p.inside[j] + along * (q.inside[j] - p.inside[j]);
      cut.height = p.height + along * (q.height - p.height);
    }
    now = 1 - now;
    n = kept;
    if (n == 0) return Over::nothing;
  }
  if (std::abs(dot(t.triangle->normal(), normal_)) < steep_cosine) return Over::border;
  const auto& part = parts[now];
  std::array<double, 3> middle{};
  for (std::size_t i = 0; i < n; ++i) {
    if (std::abs(part[i].height) > limit_) return Over::border;
    for (std::size_t k = 0; k < 3; ++k) middle[k] += part[i].inside[k] / static_cast<double>(n);
  }
  has_seed_ |= std::min({middle[0], middle[1], middle[2]}) > tiny_;
  return Over::part;
}

}  // namespace geomesh::search
