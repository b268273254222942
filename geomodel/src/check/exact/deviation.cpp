// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/exact/deviation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace geomesh::geomodel::checking {
namespace {

/// Largest number of pieces into which a triangle is cut to prove that it lies within the tolerance. Further pieces are
/// only sampled at their corners.
constexpr std::size_t most_pieces = 4000;
/// If a corner of a piece is farther than the tolerance at a place where this is no error, the piece is not bisected
/// further after this number of bisections. Eight bisections divide the edges of a triangle by sixteen.
constexpr int depth_beyond = 8;

double length(const Vec3& a) { return std::sqrt(dot(a, a)); }

double area_of(const Vec3& a, const Vec3& b, const Vec3& c) { return 0.5 * length(cross(b - a, c - a)); }

std::vector<Box3> boxes_of(const std::vector<Corners>& triangles) {
  std::vector<Box3> boxes;
  boxes.reserve(triangles.size());
  for (const Corners& t : triangles) boxes.push_back(box_of(t[0], t[1], t[2]));
  return boxes;
}

/// Returns the distance of two segments. Ericson 2005, section 5.1.9.
double segment_distance(const Vec3& p, const Vec3& q, const Vec3& u, const Vec3& v) {
  const Vec3 d = q - p, e = v - u, r = p - u;
  const double dd = dot(d, d), ee = dot(e, e), er = dot(e, r), dr = dot(d, r), de = dot(d, e);
  const double det = dd * ee - de * de;
  double s = det > 0 ? std::clamp((de * er - dr * ee) / det, 0.0, 1.0) : 0.0;
  double t = ee > 0 ? (de * s + er) / ee : 0.0;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = dd > 0 ? std::clamp((de * t - dr) / dd, 0.0, 1.0) : 0.0;
  }
  return length((p + s * d) - (u + t * e));
}

}  // namespace

Vec3 nearest_on_triangle(const Vec3& p, const Corners& t) {
  const auto on_edge = [&](const Vec3& a, const Vec3& b) {
    const Vec3 d = b - a;
    const double l = dot(d, d);
    return l > 0 ? a + std::clamp(dot(p - a, d) / l, 0.0, 1.0) * d : a;
  };
  const Vec3 n = cross(t[1] - t[0], t[2] - t[0]);
  bool inside = dot(n, n) > 0;
  for (std::size_t i = 0; inside && i < 3; ++i) {
    const Vec3 &a = t[i], &b = t[(i + 1) % 3];
    inside = dot(cross(b - a, p - a), n) >= 0;
  }
  if (inside) return p - (dot(p - t[0], n) / dot(n, n)) * n;
  Vec3 best = on_edge(t[0], t[1]);
  for (const Vec3& q : {on_edge(t[1], t[2]), on_edge(t[2], t[0])})
    if (dot(q - p, q - p) < dot(best - p, best - p)) best = q;
  return best;
}

TriangleSet::TriangleSet(std::vector<Corners> triangles)
    : triangles_(std::move(triangles)), tree_(boxes_of(triangles_)) {
  const auto less = [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
  std::map<Vec3, Index, decltype(less)> ids(less);
  for (const Corners& t : triangles_) {
    std::array<Index, 3> row{};
    for (std::size_t i = 0; i < 3; ++i) {
      row[i] = ids.try_emplace(t[i], static_cast<Index>(ids.size())).first->second;
      box_.add(t[i]);
    }
    corner_ids_.push_back(row);
  }
}

std::vector<TriangleSet::Near> TriangleSet::near(const Vec3& p, double reach) const {
  std::vector<Near> found;
  tree_.query(inflated(box_of(p, p, p), reach), [&](Index t) {
    const Vec3 q = nearest_on_triangle(p, triangles_[t]);
    const double d = length(q - p);
    if (d <= reach) found.push_back({t, d, q});
  });
  std::sort(found.begin(), found.end(), [](const Near& a, const Near& b) { return a.triangle < b.triangle; });
  return found;
}

double TriangleSet::distance(const Vec3& p) const {
  if (empty()) return std::numeric_limits<double>::infinity();
  double reach = 1e-3 * length(box_.max - box_.min) + 1e-300;
  for (;; reach *= 2) {
    double best = std::numeric_limits<double>::infinity();
    for (const Near& n : near(p, reach)) best = std::min(best, n.distance);
    if (best <= reach) return best;
  }
}

std::optional<std::array<Vec3, 2>> TriangleSet::shared_edge(Index a, Index b) const {
  std::array<Vec3, 2> edge;
  std::size_t n = 0;
  for (std::size_t i = 0; i < 3 && n < 2; ++i)
    if (const auto& ids = corner_ids_[b]; std::find(ids.begin(), ids.end(), corner_ids_[a][i]) != ids.end())
      edge[n++] = triangles_[a][i];
  if (n < 2) return std::nullopt;
  return edge;
}

DeviationChecker::DeviationChecker(const TriangleSet& set, double tolerance, std::function<bool(const Vec3&)> is_due)
    : set_(set), tolerance_(tolerance), is_due_(std::move(is_due)) {}

DeviationChecker::Spot DeviationChecker::look(const Vec3& p) const { return {p, set_.near(p, tolerance_)}; }

bool DeviationChecker::is_proven_across_edge(const Spot& a, const Spot& b, const Spot& c) const {
  for (const auto& x : a.near) {
    const auto xb = std::find_if(b.near.begin(), b.near.end(), [&](const auto& n) { return n.triangle == x.triangle; });
    if (xb == b.near.end()) continue;
    for (const auto& y : c.near) {
      const auto edge = set_.shared_edge(x.triangle, y.triangle);
      if (!edge) continue;
      const double off = std::max({x.distance, xb->distance, y.distance});
      const double gap = std::max(segment_distance(x.point, y.point, (*edge)[0], (*edge)[1]),
                                  segment_distance(xb->point, y.point, (*edge)[0], (*edge)[1]));
      if (off + gap <= tolerance_) return true;
    }
  }
  return false;
}

bool DeviationChecker::is_proven(const Piece& piece, double longest) const {
  const auto& [a, b, c] = piece.corners;
  for (const auto& n : a.near) {
    const auto has = [&](const Spot& s) {
      return std::any_of(s.near.begin(), s.near.end(), [&](const auto& m) { return m.triangle == n.triangle; });
    };
    if (has(b) && has(c)) return true;
  }
  double nearest = tolerance_;
  for (const Spot& s : piece.corners)
    for (const auto& n : s.near) nearest = std::min(nearest, n.distance);
  return nearest + longest <= tolerance_ || is_proven_across_edge(a, b, c) || is_proven_across_edge(b, c, a) ||
         is_proven_across_edge(c, a, b);
}

std::optional<Vec3> DeviationChecker::check(const Corners& triangle, Deviation& so_far) const {
  std::vector<Piece> open{{{look(triangle[0]), look(triangle[1]), look(triangle[2])}, 0}};
  const auto note = [&](const Spot& s) {
    double d = tolerance_;
    for (const auto& n : s.near) d = std::min(d, n.distance);
    if (!s.near.empty()) so_far.largest = std::max(so_far.largest, d);
  };
  for (const Spot& s : open[0].corners) {
    if (is_fault(s)) return s.p;
    note(s);
  }
  so_far.area += area_of(triangle[0], triangle[1], triangle[2]);
  for (std::size_t n_pieces = 1; !open.empty(); ++n_pieces) {
    Piece piece = std::move(open.back());
    open.pop_back();
    std::size_t longest_at = 0;
    std::array<double, 3> edge{};
    for (std::size_t i = 0; i < 3; ++i) {
      edge[i] = length(piece.corners[(i + 1) % 3].p - piece.corners[i].p);
      if (edge[i] > edge[longest_at]) longest_at = i;
    }
    const double longest = edge[longest_at], area = area_of(piece.corners[0].p, piece.corners[1].p, piece.corners[2].p);
    const auto far =
        std::count_if(piece.corners.begin(), piece.corners.end(), [](const Spot& s) { return s.near.empty(); });
    if (far == 0 && is_proven(piece, longest)) {
      so_far.proven += area;
      continue;
    }
    const bool is_small = far > 0 ? piece.depth >= depth_beyond || longest <= tolerance_ : 4 * longest <= tolerance_;
    if (is_small || n_pieces >= most_pieces) {
      if (far == 3) so_far.beyond += area;
      so_far.spacing = std::max(so_far.spacing, longest);
      continue;
    }
    Spot &a = piece.corners[longest_at], &b = piece.corners[(longest_at + 1) % 3],
         &c = piece.corners[(longest_at + 2) % 3];
    Spot middle = look(0.5 * (a.p + b.p));
    if (is_fault(middle)) return middle.p;
    note(middle);
    open.push_back({{a, middle, c}, piece.depth + 1});
    open.push_back({{middle, std::move(b), std::move(c)}, piece.depth + 1});
  }
  return std::nullopt;
}

}  // namespace geomesh::geomodel::checking
