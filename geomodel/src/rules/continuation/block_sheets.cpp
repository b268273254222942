// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/block_sheets.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "naming/sums.hpp"
#include "rules/continuation/horizon_division.hpp"
#include "rules/continuation/sheet_border.hpp"

namespace geomesh::geomodel {
namespace {

/// Places of the grid are apart by this share of the radius, so that a disc that fits into a gap covers some of them.
constexpr double step_of_radius = 0.5;
/// More places of a grid than this take seconds: the distance is a tiny share of the model then.
constexpr double most_places = 1e6;

/// The horizon that is continued, and what it is continued in. All of it is referred to and outlives its use.
struct Setting {
  const TriangulatedSurface& horizon;
  Index row;
  const BlockFramework& framework;
  const Walls& cutters;
  const Walls& walls;
  double within;
  const HorizonDivision& division;
  bool fills_blocks, has_margin;
};

/// Discs in the map that meet no wall: a horizon that ends there ends in the open.
class OpenPlaces {
 public:
  OpenPlaces(const Walls& walls, Index row, double radius) : walls_(walls), row_(row), radius_(radius) {}

  /// The disc about a place of the horizon, unless it meets a wall, along the sheet in four directions of the map, or
  /// the disc of twice its radius meets walls on opposite sides. A wall that holds the place counts.
  void add(const Vec3& centre, const Vec2& slope) {
    constexpr int n_lines = 4;
    for (int k = 0; k < n_lines; ++k) {
      const double angle = std::numbers::pi * k / n_lines;
      const double x = radius_ * std::cos(angle), y = radius_ * std::sin(angle);
      const Vec3 way{x, y, slope.x * x + slope.y * y};
      if (walls_.first_hit(centre - way, centre + way, row_)) return;
      if (walls_.first_hit(centre, centre + 2.0 * way, row_) && walls_.first_hit(centre, centre - 2.0 * way, row_))
        return;
    }
    centres_.push_back(centre);
  }
  bool holds(const Vec3& p) const {
    return std::ranges::any_of(centres_, [&](const Vec3& q) { return std::hypot(p.x - q.x, p.y - q.y) < radius_; });
  }

 private:
  const Walls& walls_;
  Index row_;
  double radius_;
  std::vector<Vec3> centres_;
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
        foot_(points_),
        n_border_(points_.size()),
        open_(setting.walls, setting.row, radius_) {
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
    made.block = block_;
    std::set<Index> walls;
    for (std::size_t k = 0; k < all->size(); ++k) {
      const PlanarTriangle& t = (*all)[k];
      if (!begins_at_border[k]) continue;
      walls.insert(walls_of[k].begin(), walls_of[k].end());
      book(t.vertices, made);
      add(t.vertices, made);
    }
    if (s_.has_margin) add_margin(*all, begins_at_border, made);
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
        foot_.push_back(p.foot);
        in_block_.push_back(!p.has_met_wall && s_.framework.block_at(p.at) == block_);
      }
  }

  void find_open_places() {
    if (s_.fills_blocks) return;
    for (std::size_t v = n_border_; v < points_.size(); ++v)
      if (in_block_[v] && distance_[v] > radius_ && !(s_.has_margin && is_beyond_horizon(v)))
        open_.add(points_[v], slope_[v]);
  }

  /// Whether another horizon lies between a place and the border. What only passes a fault or body is in the block.
  bool is_beyond_horizon(std::size_t v) const {
    return std::ranges::any_of(s_.walls.surfaces_on(foot_[v], points_[v]),
                               [&](Index s) { return s != s_.row && !s_.cutters.holds(s); });
  }

  /// Whether the triangle fills some of the block that is not open. Adds the walls that it runs through.
  bool is_filled(const std::array<Index, 3>& t, std::set<Index>& walls) const {
    bool reaches_in = false;
    for (const Index v : t) {
      if (!in_block_[v]) continue;
      if (open_.holds(points_[v])) return false;
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

  void add(const std::array<Index, 3>& t, BlockExtension& made) {
    Triangle own;
    for (std::size_t i = 0; i < 3; ++i) own[i] = row_of(t[i], made);
    if (!border_.faces_up()) std::swap(own[1], own[2]);
    made.triangles.push_back(own);
  }

  /// Triangles beyond the walls that touch those kept.
  void add_margin(const std::vector<PlanarTriangle>& all, const std::vector<bool>& is_kept, BlockExtension& made) {
    std::vector<bool> is_reached(points_.size(), false);
    for (std::size_t k = 0; k < all.size(); ++k)
      if (is_kept[k])
        for (const Index v : all[k].vertices) is_reached[v] = true;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::array<Index, 3>& t = all[k].vertices;
      if (is_kept[k] || all[k].depth % 2 != 0 || std::ranges::any_of(t, [&](Index v) { return in_block_[v]; }) ||
          std::ranges::none_of(t, [&](Index v) { return is_reached[v]; }) ||
          s_.framework.overlaps(block_, {points_[t[0]], points_[t[1]], points_[t[2]]}))
        continue;
      add(t, made);
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
  std::vector<Vec3> foot_;      ///< the nearest place of the border
  std::vector<bool> in_block_;  ///< and to be filled: not where the border has met its wall
  std::size_t n_border_;
  OpenPlaces open_;
  std::map<Index, VertexIndex> added_;
};

}  // namespace

DividedHorizon continue_in_blocks(const TriangulatedSurface& horizon, Index row, const BorderStates& states,
                                  const BlockSetting& setting) {
  const auto& [framework, cutters, walls, within, fills_blocks, is_left_out, has_margin] = setting;
  const HorizonDivision division(horizon, row, framework, cutters, states);
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
      extension =
          Continuation({horizon, row, framework, cutters, walls, within, division, fills_blocks, has_margin}, b, sheet)
              .make();
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
