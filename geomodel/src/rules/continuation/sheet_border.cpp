// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/sheet_border.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

#include "arrangement/search/bvh.hpp"
#include "common/union_find.hpp"
#include "geomesh/core/predicates.hpp"
#include "naming/sheets.hpp"
#include "naming/sums.hpp"
#include "rules/extend/extend.hpp"

namespace geomesh::geomodel {
namespace {

Vec3 normal(const TriangulatedSurface& s, const Triangle& t) {
  return cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]);
}

/// Mean normals of a part of a horizon; single triangles of a noisy grid are poor estimates of its direction.
class SheetNormals {
 public:
  SheetNormals(const TriangulatedSurface& horizon, const std::vector<Triangle>& sheet) {
    std::vector<Box3> boxes;
    for (const Triangle& t : sheet) {
      normals_.push_back(normal(horizon, t));
      centres_.push_back((1.0 / 3) * (horizon.points[t[0]] + horizon.points[t[1]] + horizon.points[t[2]]));
      boxes.emplace_back().add(centres_.back());
    }
    tree_.emplace(boxes);
  }
  /// Returns the sum of the normals of triangle `own` and of triangles with centres within a distance of p.
  Vec3 about(const Vec3& p, double within, Index own) const {
    Box3 near;
    near.add(p - Vec3{within, within, within});
    near.add(p + Vec3{within, within, within});
    Vec3 sum = normals_[own];
    tree_->boxes_meeting(near, [&](Index t) {
      if (t != own && norm(centres_[t] - p) <= within) sum = sum + normals_[t];
    });
    return sum;
  }

 private:
  std::vector<Vec3> normals_, centres_;
  std::optional<arrangement::BoxTree> tree_;
};

}  // namespace

SheetBorder::SheetBorder(const TriangulatedSurface& horizon, const HorizonDivision& division,
                         const std::vector<Triangle>& sheet, double within, bool averages)
    : within_(within) {
  std::map<MapEdge, std::pair<int, Index>> uses;
  CompensatedSum up;
  for (Index k = 0; k < sheet.size(); ++k) {
    const Triangle& t = sheet[k];
    up.add(normal(horizon, t).z);
    for (std::size_t i = 0; i < 3; ++i) {
      auto& use = uses[std::minmax(t[i], t[(i + 1) % 3])];
      ++use.first;
      use.second = k;
    }
  }
  faces_up_ = up.value() >= 0;
  std::map<VertexIndex, Index> index;
  const auto row = [&](VertexIndex v) {
    const auto [at, is_new] = index.emplace(v, static_cast<Index>(points_.size()));
    if (is_new) {
      points_.push_back(horizon.points[v]);
      rows_.push_back(v);
    }
    return at->second;
  };
  std::optional<SheetNormals> means;
  if (averages) means.emplace(horizon, sheet);
  for (const auto& [edge, use] : uses) {
    if (use.first != 1) continue;
    const Index a = row(edge.first), b = row(edge.second);
    constraints_.emplace_back(std::min(a, b), std::max(a, b));
    const std::optional<BorderState> state = division.border_state(edge.first, edge.second);
    if (state == BorderState::before_wall) is_end_.insert(constraints_.back());
    const Vec3 middle = 0.5 * (horizon.points[edge.first] + horizon.points[edge.second]);
    const Vec3 n = means ? means->about(middle, within, use.second) : normal(horizon, sheet[use.second]);
    const bool is_steep = std::hypot(n.x, n.y) > steepest_slope * std::abs(n.z);
    const Triangle& t = sheet[use.second];
    edges_.push_back({a, b, is_steep ? Vec2{0, 0} : Vec2{-n.x / n.z, -n.y / n.z}, state == BorderState::met_wall,
                      (1.0 / 3) * (horizon.points[t[0]] + horizon.points[t[1]] + horizon.points[t[2]])});
  }
  has_met_wall_.assign(points_.size(), true);
  for (const Edge& e : edges_)
    if (!e.has_met_wall) has_met_wall_[e.a] = has_met_wall_[e.b] = false;
  index_edges();
}

void SheetBorder::index_edges() {
  std::vector<Box3> boxes;
  for (const Edge& e : edges_) {
    Box3& box = boxes.emplace_back();
    for (const Index v : {e.a, e.b}) box.add({points_[v].x, points_[v].y, 0});
  }
  tree_.emplace(boxes);
}

std::vector<Index> SheetBorder::edges_between(const Vec2& low, const Vec2& high) const {
  std::vector<Index> found;
  tree_->boxes_meeting({{low.x, low.y, 0}, {high.x, high.y, 0}}, [&](Index e) { found.push_back(e); });
  std::ranges::sort(found);
  return found;
}

SheetBorder::Place SheetBorder::continued_at(const Vec2& p) const {
  for (double reach = within_; reach > 0 && reach < std::numeric_limits<double>::infinity(); reach *= 2) {
    const std::vector<Index> near = edges_between({p.x - reach, p.y - reach}, {p.x + reach, p.y + reach});
    const Place place = continued_from(near, p);
    if (place.distance <= reach || near.size() == edges_.size()) return place;
  }
  std::vector<Index> all(edges_.size());
  std::iota(all.begin(), all.end(), Index{0});
  return continued_from(all, p);
}

SheetBorder::Place SheetBorder::continued_from(const std::vector<Index>& edges, const Vec2& p) const {
  double least = std::numeric_limits<double>::infinity(), z = 0;
  Vec2 slope{0, 0};
  Vec3 inside;
  bool has_met_wall = false;
  for (const Index row : edges) {
    const Edge& e = edges_[row];
    const Vec3 &a = points_[e.a], &b = points_[e.b];
    const double dx = b.x - a.x, dy = b.y - a.y, l2 = dx * dx + dy * dy;
    const double t = l2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / l2, 0.0, 1.0) : 0.0;
    const Vec3 foot = a + t * (b - a);
    const double x = p.x - foot.x, y = p.y - foot.y, d = std::hypot(x, y);
    if (!(d < least)) continue;
    least = d;
    inside = e.inside;
    has_met_wall = t <= 0 ? has_met_wall_[e.a] : t >= 1 ? has_met_wall_[e.b] : e.has_met_wall;
    slope = d > within_ ? Vec2{0, 0} : e.slope;
    const double share = d > within_ ? within_ / d : 1;
    z = foot.z + share * (e.slope.x * x + e.slope.y * y);
  }
  return {{p.x, p.y, z}, least, slope, has_met_wall, inside};
}

bool SheetBorder::meets(const Vec2& from, const Vec2& to) const {
  const std::vector<Index> near =
      edges_between({std::min(from.x, to.x), std::min(from.y, to.y)}, {std::max(from.x, to.x), std::max(from.y, to.y)});
  return std::ranges::any_of(near, [&](Index row) {
    const Edge& e = edges_[row];
    const Vec2 a{points_[e.a].x, points_[e.a].y}, b{points_[e.b].x, points_[e.b].y};
    return orient2d(a, b, from) != orient2d(a, b, to) && orient2d(from, to, a) != orient2d(from, to, b);
  });
}

std::vector<bool> SheetBorder::beside_border(const std::vector<PlanarTriangle>& all,
                                             const std::vector<bool>& is_kept) const {
  const std::set<std::pair<Index, Index>> constraints(constraints_.begin(), constraints_.end());
  std::map<std::pair<Index, Index>, Index> at_edge;
  UnionFind joined(all.size());
  const auto for_each_edge_of = [&](Index t, auto&& visit) {
    if (!is_kept[t]) return;
    for (std::size_t i = 0; i < 3; ++i)
      visit(std::pair<Index, Index>(std::minmax(all[t].vertices[i], all[t].vertices[(i + 1) % 3])));
  };
  for (Index t = 0; t < all.size(); ++t)
    for_each_edge_of(t, [&](const std::pair<Index, Index>& e) {
      if (constraints.contains(e)) return;
      const auto [at, is_new] = at_edge.emplace(e, t);
      if (!is_new) joined.unite(at->second, t);
    });
  std::set<Index> begin;
  for (Index t = 0; t < all.size(); ++t)
    if (all[t].depth % 2 == 0)
      for_each_edge_of(t, [&](const std::pair<Index, Index>& e) {
        if (is_end_.contains(e)) begin.insert(joined.find(t));
      });
  std::vector<bool> is_beside(all.size());
  for (Index t = 0; t < all.size(); ++t) is_beside[t] = is_kept[t] && begin.contains(joined.find(t));
  return is_beside;
}

}  // namespace geomesh::geomodel
