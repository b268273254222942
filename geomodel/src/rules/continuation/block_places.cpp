// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/block_places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "naming/sums.hpp"

namespace geomesh::geomodel {
namespace {

/// Spacing of the grid as a fraction of the disc's radius, so that a disc that fits into a gap covers some grid points.
constexpr double step_of_radius = 0.5;
/// Largest number of grid points. More would take seconds, and arise only for a tiny distance of continuation.
constexpr double most_places = 1e6;

}  // namespace

BlockPlaces::BlockPlaces(const HorizonInBlocks& setting, Index block, const std::vector<Triangle>& sheet)
    : s_(setting),
      block_(block),
      radius_(setting.within / 2),
      step_(step_of_radius * radius_),
      border_(setting.horizon, setting.division, sheet, setting.within, setting.fills_blocks),
      points_(border_.points()),
      distance_(points_.size(), 0),
      slope_(points_.size(), Vec2{0, 0}),
      inside_(points_),
      n_border_(points_.size()) {
  for (const Vec3& p : points_) in_block_.push_back(s_.framework.block_at(p) == block_);
  if (!has_grid()) return;
  add_grid();
  find_open_places();
}

bool BlockPlaces::has_grid() const {
  const Vec3 extent = s_.framework.bounds(block_).max - s_.framework.bounds(block_).min;
  return (extent.x / step_) * (extent.y / step_) <= most_places;
}

/// Adds grid points over the block's bounding box, on a grid that is fixed in space.
void BlockPlaces::add_grid() {
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
      inside_.push_back(p.inside);
      in_block_.push_back(!p.has_met_wall && s_.framework.block_at(p.at) == block_ &&
                          (s_.has_margin || !is_beyond_horizon(points_.size() - 1)));
    }
}

void BlockPlaces::find_open_places() {
  if (s_.fills_blocks) return;
  for (std::size_t v = n_border_; v < points_.size(); ++v)
    if (in_block_[v] && distance_[v] > radius_ && !(s_.has_margin && is_beyond_horizon(v)) && ends_in_the_open(v))
      open_.push_back(points_[v]);
  if (!open_.empty()) nearest_open_.emplace(open_);
}

/// Returns whether another horizon lies between a place and the border from which the horizon is continued. A place
/// that is only behind a fault or body counts as in the block.
bool BlockPlaces::is_beyond_horizon(std::size_t v) const {
  return std::ranges::any_of(s_.walls.surfaces_on(inside_[v], points_[v]),
                             [&](Index s) { return s != s_.row && !s_.cutters.holds(s); });
}

/// Returns whether a disc around a place of the continued horizon is open. The disc is not open if it meets a bounding
/// surface along the horizon in four directions of the map, or if the disc of twice its radius meets bounding surfaces,
/// or the horizon itself, on opposite sides. A bounding surface through the place counts. Nor is the disc open if a
/// fault or body lies within its radius above or below the place: the way to it along the horizon is long where both
/// meet at a low angle, although elements of this size cannot pass between them.
bool BlockPlaces::ends_in_the_open(std::size_t v) const {
  const Vec3& centre = points_[v];
  if (s_.walls.meets_disc(centre, radius_, slope_[v], s_.row)) return false;
  const Vec3 normal{-slope_[v].x, -slope_[v].y, 1};
  const Vec3 up = (radius_ / norm(normal)) * normal;
  if (s_.cutters.first_surface(centre, centre + up, s_.row) || s_.cutters.first_surface(centre, centre - up, s_.row))
    return false;
  return std::ranges::none_of(Walls::lines_of_disc(2 * radius_, slope_[v]), [&](const Vec3& way) {
    if (s_.walls.first_hit(centre, centre + way, s_.row) && s_.walls.first_hit(centre, centre - way, s_.row))
      return true;
    const Vec2 at{centre.x, centre.y};
    return distance_[v] <= 2 * radius_ && border_.meets(at, {at.x + way.x, at.y + way.y}) &&
           border_.meets(at, {at.x - way.x, at.y - way.y});
  });
}

/// Returns whether a disc that meets neither the horizon nor a bounding surface covers the place, which is then not
/// filled. Far from the horizon, the disc's centre may lie anywhere between four grid points: otherwise a rim along the
/// bounding surfaces, one grid step wide, would be filled.
bool BlockPlaces::is_open(Index v) const {
  if (open_.empty()) return false;
  const Vec3 &p = points_[v], &q = open_[nearest_open_->find(p.x, p.y)];
  const double off = std::hypot(p.x - q.x, p.y - q.y);
  return off < radius_ || (distance_[v] > s_.within && off <= radius_ + std::numbers::sqrt2 * step_);
}

bool BlockPlaces::overlaps(const std::array<Index, 3>& t) const {
  return std::ranges::any_of(t, [&](Index v) { return in_block_[v]; }) ||
         s_.framework.overlaps(block_, {points_[t[0]], points_[t[1]], points_[t[2]]});
}

bool BlockPlaces::is_filled(const std::array<Index, 3>& t, std::set<Index>& walls) const {
  bool reaches_in = false;
  for (const Index v : t) {
    if (!in_block_[v]) continue;
    if (is_open(v)) return false;
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
  if (!reaches_in && !overlaps(t)) return false;
  if (leaves && crossed.empty()) crossed.insert(Walls::side_of_volume);
  walls.insert(crossed.begin(), crossed.end());
  return true;
}

}  // namespace geomesh::geomodel
