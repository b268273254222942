// SPDX-License-Identifier: MIT
#include "plc/flat_patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "common/flat_map.hpp"
#include "common/geometry.hpp"
#include "common/sort_unique.hpp"
#include "geomesh/core/predicates.hpp"

namespace geomesh {

std::optional<FlatPatch> FlatPatch::of(std::span<const Vec3> points, std::vector<Triangle> triangles) {
  FlatPatch patch(points, std::move(triangles));
  if (!patch.project() || !patch.join()) return std::nullopt;
  patch.sort_corners();
  return patch;
}

/// Drops the axis in which the largest triangle's normal is longest. The first triangle is counter-clockwise in the
/// projection, and the orientation of all others is made the same.
bool FlatPatch::project() {
  Vec3 normal;
  for (const Triangle& t : triangles_) {
    const Vec3 n = triangle_normal(points_[t[0]], points_[t[1]], points_[t[2]]);
    if (squared_length(n) > squared_length(normal)) normal = n;
  }
  const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
  projection_.axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  const auto turn = [&](const Triangle& t) { return orient2d(flat(t[0]), flat(t[1]), flat(t[2])); };
  if (turn(triangles_[0]) == Sign::negative) projection_.handedness = PlaneProjection::Handedness::left;
  for (Triangle& t : triangles_) {
    const Sign sign = turn(t);
    if (sign == Sign::zero) return false;
    is_turned_.push_back(sign == Sign::negative);
    if (sign == Sign::negative) std::swap(t[1], t[2]);
  }
  return true;
}

bool FlatPatch::join() {
  const Index n = static_cast<Index>(3 * triangles_.size());
  opposite_.assign(n, no_index);
  EdgeMap corner_of;
  for (Index c = 0; c < n; ++c) {
    const Edge e{vertex(c), vertex(next(c))};
    const Index d = corner_of.find(e);
    if (d == no_index) {
      corner_of.insert(e, c);
      continue;
    }
    if (opposite_[d] != no_index || vertex(d) == e[0]) return false;
    opposite_[c] = d;
    opposite_[d] = c;
  }
  return true;
}

void FlatPatch::sort_corners() {
  corners_.resize(opposite_.size());
  std::iota(corners_.begin(), corners_.end(), Index{0});
  std::sort(corners_.begin(), corners_.end(),
            [&](Index c, Index d) { return vertex(c) != vertex(d) ? vertex(c) < vertex(d) : c < d; });
}

std::span<const Index> FlatPatch::corners_at(VertexIndex v) const {
  const auto at = [&](Index c) { return vertex(c); };
  const auto first = std::ranges::lower_bound(corners_, v, {}, at),
             last = std::ranges::upper_bound(corners_, v, {}, at);
  return std::span(corners_).subspan(static_cast<std::size_t>(first - corners_.begin()),
                                     static_cast<std::size_t>(last - first));
}

Index FlatPatch::next_on_border(Index corner) const {
  Index c = next(corner);
  while (opposite_[c] != no_index) c = next(opposite_[c]);
  return c;
}

/// Returns the loops. The outer loop is the one with the least vertex (by x, y, z), because that is a corner of the
/// patch's hull. A loop may pass a vertex twice, where the patch touches itself.
std::vector<std::vector<VertexIndex>> FlatPatch::loops() const {
  std::vector<std::vector<VertexIndex>> out;
  std::vector<bool> is_done(opposite_.size(), false);
  VertexIndex least = vertex(0);
  std::size_t outer = 0;
  for (Index start = 0; start < opposite_.size(); ++start) {
    if (opposite_[start] != no_index || is_done[start]) continue;
    out.emplace_back();
    for (Index c = start; !is_done[c]; c = next_on_border(c)) {
      is_done[c] = true;
      out.back().push_back(vertex(c));
      if (compare_lexicographic(points_[vertex(c)], points_[least]) > 0) continue;
      least = vertex(c);
      outer = out.size() - 1;
    }
  }
  if (!out.empty()) std::swap(out[0], out[outer]);
  return out;
}

FacetPolygon FlatPatch::polygon(std::vector<Edge> segments) const {
  FacetPolygon out;
  out.loops = loops();
  std::vector<VertexIndex> outlined;
  for (const auto& loop : out.loops) outlined.insert(outlined.end(), loop.begin(), loop.end());
  for (const Edge& s : segments) outlined.insert(outlined.end(), s.begin(), s.end());
  sort_unique(outlined);
  for (const Index c : corners_) {
    const VertexIndex v = vertex(c);
    const bool is_known = !out.inner_points.empty() && out.inner_points.back() == v;
    if (!is_known && !std::binary_search(outlined.begin(), outlined.end(), v)) out.inner_points.push_back(v);
  }
  out.segments = std::move(segments);
  return out;
}

bool FlatPatch::holds(Index triangle, const Vec2& x) const {
  const Triangle& t = triangles_[triangle];
  for (unsigned k = 0; k < 3; ++k)
    if (orient2d(flat(t[k]), flat(t[(k + 1) % 3]), x) == Sign::negative) return false;
  return true;
}

/// Returns the largest of the distances by which point x lies beyond the triangle's sides; 0 if it lies inside.
double FlatPatch::distance_outside(Index triangle, const Vec2& x) const {
  const Triangle& t = triangles_[triangle];
  double most = 0;
  for (unsigned k = 0; k < 3; ++k) {
    const Vec2 a = flat(t[k]), b = flat(t[(k + 1) % 3]);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    most = std::max(most, ((b.y - a.y) * (x.x - a.x) - (b.x - a.x) * (x.y - a.y)) / length);
  }
  return most;
}

/// Walks straight from v to x. Returns nothing if the line leaves the patch, which only rounding of x causes.
std::optional<Index> FlatPatch::walk_from(VertexIndex v, const Vec2& x) const {
  const Vec2 from = flat(v);
  Index at = no_index;
  for (const Index c : corners_at(v)) {
    const VertexIndex right = vertex(next(c)), left = vertex(next(next(c)));
    if (orient2d(from, flat(right), x) == Sign::negative || orient2d(from, x, flat(left)) == Sign::negative) continue;
    if (orient2d(flat(right), flat(left), x) != Sign::negative) return c / 3;
    at = opposite(next(c));
    break;
  }
  for (std::size_t step = 0; step < opposite_.size() && at != no_index; ++step) {
    if (holds(at / 3, x)) return at / 3;
    const Index from_right = next(at), from_apex = next(next(at));
    at = opposite(orient2d(from, x, flat(vertex(from_apex))) == Sign::positive ? from_right : from_apex);
  }
  return std::nullopt;
}

Index FlatPatch::triangle_at_centroid(const std::array<Vec3, 3>& corners, std::span<const VertexIndex> near) const {
  const Vec2 x = projection_((1.0 / 3) * (corners[0] + corners[1] + corners[2]));
  for (const VertexIndex v : near)
    if (const auto found = walk_from(v, x)) return *found;
  for (Index t = 0; t < triangles_.size(); ++t)
    if (holds(t, x)) return t;
  // If rounding has moved the centroid out of the patch, the nearest triangle is returned.
  Index nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (Index t = 0; t < triangles_.size(); ++t)
    if (const double off = distance_outside(t, x); off < least) {
      least = off;
      nearest = t;
    }
  return nearest;
}

}  // namespace geomesh
