// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/block_sheets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "common/union_find.hpp"
#include "naming/sheets.hpp"
#include "naming/sums.hpp"
#include "rules/continuation/border_chains.hpp"
#include "rules/planar/planar_fill.hpp"

namespace geomesh::geomodel {
namespace {

using MapEdge = std::pair<VertexIndex, VertexIndex>;

/// Steeper slopes are continued level: a sheet that is folded over there has no one height.
constexpr double steepest_slope = 3;
/// Places of the grid are apart by this share of the radius, so that a disc that fits into a gap covers some of them.
constexpr double step_of_radius = 0.5;
/// More places of a grid than this take seconds: the distance is a tiny share of the model then.
constexpr double most_places = 1e6;

/// The triangles of a horizon with their blocks and neighbours.
class Division {
 public:
  Division(const TriangulatedSurface& horizon, Index row, const BlockFramework& framework, const Walls& cutters,
           const std::map<MapEdge, BorderState>& states)
      : horizon_(horizon), row_(row), framework_(framework), cutters_(cutters) {
    for (const auto& [edge, state] : states) states_[std::minmax(edge.first, edge.second)] = state;
    const std::vector<VertexIndex> merged = merge_equal_points(horizon.points);
    for (const Triangle& t : horizon.triangles) triangles_.push_back({merged[t[0]], merged[t[1]], merged[t[2]]});
    std::map<MapEdge, bool> crosses;
    for (Index t = 0; t < triangles_.size(); ++t)
      for_each_edge_of(t, [&](VertexIndex a, VertexIndex b) { at_edge_[std::minmax(a, b)].push_back(t); });
    for (const auto& [edge, _] : at_edge_) crosses[edge] = is_parted(edge.first, edge.second);
    for (Index t = 0; t < triangles_.size(); ++t) {
      bool is_crossing = false;
      for_each_edge_of(t, [&](VertexIndex a, VertexIndex b) { is_crossing |= crosses.at(std::minmax(a, b)); });
      crosses_.push_back(is_crossing);
      block_.push_back(is_crossing ? no_index : block_of(t));
    }
  }

  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// Of an edge at which the horizon ends, over the first of equal points; nothing where it goes on.
  std::optional<BorderState> border_state(VertexIndex a, VertexIndex b) const {
    const auto at = states_.find(std::minmax(a, b));
    return at == states_.end() ? std::nullopt : std::optional(at->second);
  }

  /// Triangles of the block, those that hang together with them outside of the model, and those next to these that
  /// cross a wall.
  std::vector<Index> sheet_of(Index block) const {
    std::vector<Index> sheet;
    std::vector<bool> taken(triangles_.size(), false);
    for (Index t = 0; t < triangles_.size(); ++t)
      if (block_[t] == block) {
        sheet.push_back(t);
        taken[t] = true;
      }
    for (std::size_t k = 0; k < sheet.size(); ++k) {
      if (crosses_[sheet[k]]) continue;
      for_each_edge_of(sheet[k], [&](VertexIndex a, VertexIndex b) {
        for (const Index other : at_edge_.at(std::minmax(a, b)))
          if (!taken[other] && block_[other] == no_index) {
            taken[other] = true;
            sheet.push_back(other);
          }
      });
    }
    return sheet;
  }

 private:
  template <class F>
  void for_each_edge_of(Index t, F&& visit) const {
    for (std::size_t i = 0; i < 3; ++i) visit(triangles_[t][i], triangles_[t][(i + 1) % 3]);
  }
  bool is_parted(VertexIndex a, VertexIndex b) const {
    const Vec3 &p = horizon_.points[a], &q = horizon_.points[b];
    return cutters_.first_surface(p, q, row_) || cutters_.first_surface(q, p, row_);
  }
  /// By the first of some places of the triangle that lies in the model.
  Index block_of(Index t) const {
    const Vec3 &a = horizon_.points[triangles_[t][0]], &b = horizon_.points[triangles_[t][1]],
               &c = horizon_.points[triangles_[t][2]];
    const Vec3 centre = (1.0 / 3) * (a + b + c);
    for (const Vec3& p : {centre, 0.5 * (centre + a), 0.5 * (centre + b), 0.5 * (centre + c), a, b, c})
      if (const Index block = framework_.block_at(p); block != no_index) return block;
    return no_index;
  }

  const TriangulatedSurface& horizon_;
  Index row_;
  const BlockFramework& framework_;
  const Walls& cutters_;
  std::map<MapEdge, BorderState> states_;  ///< of the horizon's border
  std::vector<Triangle> triangles_;        ///< over the first of equal points
  std::map<MapEdge, std::vector<Index>> at_edge_;
  std::vector<bool> crosses_;
  std::vector<Index> block_;
};

/// The border of a sheet, and the heights at which it is continued.
class SheetBorder {
 public:
  SheetBorder(const TriangulatedSurface& horizon, const Division& division, const std::vector<Triangle>& sheet,
              double within)
      : horizon_(horizon), within_(within) {
    std::map<MapEdge, std::pair<int, const Triangle*>> uses;
    CompensatedSum up;
    for (const Triangle& t : sheet) {
      const Vec3 n = normal(t);
      up.add(n.z);
      for (std::size_t i = 0; i < 3; ++i) {
        auto& use = uses[std::minmax(t[i], t[(i + 1) % 3])];
        ++use.first;
        use.second = &t;
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
    for (const auto& [edge, use] : uses) {
      if (use.first != 1) continue;
      const Index a = row(edge.first), b = row(edge.second);
      constraints_.emplace_back(std::min(a, b), std::max(a, b));
      const std::optional<BorderState> state = division.border_state(edge.first, edge.second);
      if (state == BorderState::before_wall) is_end_.insert(constraints_.back());
      const Vec3 n = normal(*use.second);
      const bool is_steep = std::hypot(n.x, n.y) > steepest_slope * std::abs(n.z);
      edges_.push_back({points_[a], points_[b], is_steep ? Vec2{0, 0} : Vec2{-n.x / n.z, -n.y / n.z},
                        state == BorderState::met_wall});
    }
  }

  const std::vector<Vec3>& points() const { return points_; }
  VertexIndex row(Index v) const { return rows_[v]; }  ///< of the horizon
  const std::vector<std::pair<Index, Index>>& edges() const { return constraints_; }
  /// Whether the horizon stops short of a wall at an edge of points a < b.
  bool is_end(const std::pair<Index, Index>& edge) const { return is_end_.contains(edge); }
  bool faces_up() const { return faces_up_; }

  struct Place {
    Vec3 at;            ///< with the height that the border has there
    double distance;    ///< from the border in the map
    Vec2 slope;         ///< of the border where it is nearest
    bool has_met_wall;  ///< the border has there
  };
  Place continued_at(const Vec2& p) const {
    double least = std::numeric_limits<double>::infinity(), z = 0;
    Vec2 slope{0, 0};
    bool has_met_wall = false;
    for (const Edge& e : edges_) {
      const double dx = e.b.x - e.a.x, dy = e.b.y - e.a.y, l2 = dx * dx + dy * dy;
      const double t = l2 > 0 ? std::clamp(((p.x - e.a.x) * dx + (p.y - e.a.y) * dy) / l2, 0.0, 1.0) : 0.0;
      const Vec3 foot = e.a + t * (e.b - e.a);
      const double x = p.x - foot.x, y = p.y - foot.y, d = std::hypot(x, y);
      if (!(d < least)) continue;
      least = d;
      has_met_wall = e.has_met_wall;
      slope = d > within_ ? Vec2{0, 0} : e.slope;
      const double share = d > within_ ? within_ / d : 1;
      z = foot.z + share * (e.slope.x * x + e.slope.y * y);
    }
    return {{p.x, p.y, z}, least, slope, has_met_wall};
  }

  /// Per triangle, whether it is kept, lies outside of the sheet, and hangs together, through those kept, with a place
  /// where the horizon stops short of a wall: where the sheet ends because the horizon goes on beyond a wall there is
  /// nothing to continue.
  std::vector<bool> beside_border(const std::vector<PlanarTriangle>& all, const std::vector<bool>& is_kept) const {
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

 private:
  struct Edge {
    Vec3 a, b;
    Vec2 slope;
    bool has_met_wall;
  };

  Vec3 normal(const Triangle& t) const {
    const std::vector<Vec3>& p = horizon_.points;
    return cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
  }

  const TriangulatedSurface& horizon_;
  double within_;
  std::vector<Vec3> points_;
  std::vector<VertexIndex> rows_;
  std::vector<std::pair<Index, Index>> constraints_;
  std::set<std::pair<Index, Index>> is_end_;
  std::vector<Edge> edges_;
  bool faces_up_ = true;
};

/// What is continued, and in what; all outlive its use.
struct Setting {
  const TriangulatedSurface& horizon;
  Index row;
  const BlockFramework& framework;
  const Walls& walls;
  double within;
  const Division& division;
  bool fills_blocks;
};

/// The continuation of one sheet.
class Continuation {
 public:
  Continuation(const Setting& setting, Index block, const std::vector<Triangle>& sheet)
      : s_(setting),
        block_(block),
        radius_(setting.within / 2),
        step_(step_of_radius * radius_),
        border_(setting.horizon, setting.division, sheet, setting.within),
        points_(border_.points()),
        distance_(points_.size(), 0),
        slope_(points_.size(), Vec2{0, 0}),
        n_border_(points_.size()) {
    for (const Vec3& p : points_) in_block_.push_back(s_.framework.block_at(p) == block_);
    if (!has_few_places()) return;
    add_grid();
    find_open_places();
  }

  /// None where the border crosses itself in the map, and where the distance is too short for a grid.
  std::optional<BlockExtension> make() {
    if (!has_few_places()) return std::nullopt;
    std::vector<Vec2> places;
    for (const Vec3& p : points_) places.push_back({p.x, p.y});
    const auto all = triangulate_plane(places, border_.edges());
    if (!all) return std::nullopt;
    std::vector<std::set<Index>> walls_of;
    std::vector<bool> is_kept;
    for (const PlanarTriangle& t : *all) is_kept.push_back(is_filled(t.vertices, walls_of.emplace_back()));
    const std::vector<bool> begins_at_border = border_.beside_border(*all, is_kept);
    BlockExtension made;
    std::set<Index> walls;
    for (std::size_t k = 0; k < all->size(); ++k) {
      const PlanarTriangle& t = (*all)[k];
      if (!begins_at_border[k]) continue;
      walls.insert(walls_of[k].begin(), walls_of[k].end());
      book(t.vertices, made);
      Triangle own;
      for (std::size_t i = 0; i < 3; ++i) own[i] = row_of(t.vertices[i], made);
      if (!border_.faces_up()) std::swap(own[1], own[2]);
      made.triangles.push_back(own);
    }
    made.walls.assign(walls.begin(), walls.end());
    return made;
  }

 private:
  bool has_few_places() const {
    const Vec3 extent = s_.framework.bounds(block_).max - s_.framework.bounds(block_).min;
    return (extent.x / step_) * (extent.y / step_) <= most_places;
  }

  /// Places over the block's box on a grid whose origin depends on the place in space alone.
  void add_grid() {
    const Box3& box = s_.framework.bounds(block_);
    const auto first = [&](double v) { return static_cast<std::int64_t>(std::floor(v / step_)) - 1; };
    const auto last = [&](double v) { return static_cast<std::int64_t>(std::ceil(v / step_)) + 1; };
    for (std::int64_t j = first(box.min.y); j <= last(box.max.y); ++j)
      for (std::int64_t i = first(box.min.x); i <= last(box.max.x); ++i) {
        const auto p = border_.continued_at({static_cast<double>(i) * step_, static_cast<double>(j) * step_});
        if (p.distance < step_ / 2) continue;
        points_.push_back(p.at);
        distance_.push_back(p.distance);
        slope_.push_back(p.slope);
        in_block_.push_back(!p.has_met_wall && s_.framework.block_at(p.at) == block_);
      }
  }

  /// Whether a wall is within the radius of a place, looking along the sheet in four directions of the map. A wall that
  /// holds the place counts.
  bool has_wall_near(std::size_t v) const {
    constexpr int n_lines = 4;
    for (int k = 0; k < n_lines; ++k) {
      const double angle = std::numbers::pi * k / n_lines;
      const double x = radius_ * std::cos(angle), y = radius_ * std::sin(angle);
      const Vec3 &p = points_[v], way{x, y, slope_[v].x * x + slope_[v].y * y};
      if (s_.walls.first_hit(p - way, p + way, s_.row)) return true;
    }
    return false;
  }

  void find_open_places() {
    if (s_.fills_blocks) return;
    for (std::size_t v = n_border_; v < points_.size(); ++v)
      if (in_block_[v] && distance_[v] > radius_ && !has_wall_near(v)) open_.push_back(points_[v]);
  }
  bool is_open(const Vec3& p) const {
    return std::any_of(open_.begin(), open_.end(),
                       [&](const Vec3& q) { return std::hypot(p.x - q.x, p.y - q.y) < radius_; });
  }

  /// Whether the triangle fills some of the block that is not open. Adds the walls that it runs through.
  bool is_filled(const std::array<Index, 3>& t, std::set<Index>& walls) const {
    bool reaches_in = false;
    for (const Index v : t) {
      if (!in_block_[v]) continue;
      if (is_open(points_[v])) return false;
      reaches_in = true;
    }
    std::set<Index> crossed;
    bool leaves = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &a = points_[t[i]], &b = points_[t[(i + 1) % 3]];
      for (const Index s : s_.walls.surfaces_on(a, b))
        if (s != s_.row) crossed.insert(s);
      leaves = leaves || s_.walls.first_hit(a, b, s_.row) || s_.walls.first_hit(b, a, s_.row);
    }
    if (!reaches_in && !leaves) return false;
    if (!reaches_in && !s_.framework.overlaps(block_, {points_[t[0]], points_[t[1]], points_[t[2]]})) return false;
    if (leaves && crossed.empty()) crossed.insert(Walls::side_of_volume);
    walls.insert(crossed.begin(), crossed.end());
    return true;
  }

  /// The length of border, the farthest place before a wall, and what lies in the model.
  void book(const std::array<Index, 3>& t, BlockExtension& made) const {
    const auto look_at = [&](const Vec3& p, double distance) {
      if (distance <= made.farthest) return;
      made.farthest = distance;
      made.place = p;
    };
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = t[i], b = t[(i + 1) % 3];
      if (border_.is_end(std::minmax(a, b))) made.length += norm(points_[b] - points_[a]);
      if (!in_block_[a]) continue;
      look_at(points_[a], distance_[a]);
      const auto hit = s_.walls.first_hit(points_[a], points_[b], s_.row);
      if (!hit) continue;
      const Vec3 p = points_[a] + hit->share * (points_[b] - points_[a]);
      look_at(p, border_.continued_at({p.x, p.y}).distance);
    }
  }

  VertexIndex row_of(Index v, BlockExtension& made) {
    if (v < n_border_) return border_.row(v);
    const auto [at, is_new] = added_.emplace(v, no_vertex);
    if (is_new) {
      at->second = static_cast<VertexIndex>(s_.horizon.points.size() + made.added.size());
      made.added.push_back(points_[v]);
    }
    return at->second;
  }

  Setting s_;
  Index block_;
  double radius_, step_;
  SheetBorder border_;
  std::vector<Vec3> points_;  ///< those of the border, then those of the grid
  std::vector<double> distance_;
  std::vector<Vec2> slope_;
  std::vector<bool> in_block_;  ///< and to be filled: not where the border has met its wall
  std::size_t n_border_;
  std::vector<Vec3> open_;
  std::map<Index, VertexIndex> added_;
};

}  // namespace

DividedHorizon continue_in_blocks(const TriangulatedSurface& horizon, Index row, const BlockSetting& setting) {
  const auto& [framework, cutters, walls, box, within, fills_blocks, is_left_out] = setting;
  const auto states = border_states(horizon, row, walls, box, fills_blocks ? norm(box.max - box.min) : within);
  const Division division(horizon, row, framework, cutters, states);
  DividedHorizon divided{
      std::vector<bool>(horizon.triangles.size(), true), std::vector<bool>(framework.n_blocks(), true), {}};
  for (Index b = 0; b < framework.n_blocks(); ++b) {
    if (!is_left_out.empty() && is_left_out[b]) continue;
    const std::vector<Index> rows = division.sheet_of(b);
    if (rows.empty()) continue;
    std::vector<Triangle> sheet;
    for (const Index t : rows) sheet.push_back(division.triangles()[t]);
    std::optional<BlockExtension> extension;
    if (!framework.has_tip(b))
      extension = Continuation({horizon, row, framework, walls, within, division, fills_blocks}, b, sheet).make();
    if (extension) {
      if (!extension->triangles.empty()) divided.extensions.push_back(std::move(*extension));
      continue;
    }
    for (const Index t : rows) divided.is_continued[t] = false;
    divided.block_is_continued[b] = false;
  }
  return divided;
}

}  // namespace geomesh::geomodel
