// SPDX-License-Identifier: MIT
#include "remesh/start/planar_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry.hpp"
#include "common/hash.hpp"

namespace geomesh::remesh {

namespace {

/// A candidate point that is closer to another than this share of the size at the point beside it is refused before its
/// own size is evaluated. If sizes decrease by less than 0.5 per unit of distance, it would be refused anyway.
constexpr double surely_crowded = 0.5;

Vec2 plus(const Vec2& a, double t, const Vec2& d) { return {a.x + t * d.x, a.y + t * d.y}; }
double squared_distance(const Vec2& a, const Vec2& b) { return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y); }

double squared_distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d{b.x - a.x, b.y - a.y};
  const double dd = d.x * d.x + d.y * d.y;
  const double t = dd > 0 ? std::clamp(((p.x - a.x) * d.x + (p.y - a.y) * d.y) / dd, 0.0, 1.0) : 0.0;
  return squared_distance(p, plus(a, t, d));
}

int level_of(double size) { return static_cast<int>(std::floor(std::log2(size))); }

/// Returns the hash of a grid cell by its column and row, which are whole numbers. Collisions cost time only, because
/// points are compared by distance.
std::uint64_t key(double column, double row) {
  const auto whole = [](double c) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(c)); };
  return hash_of(std::array{whole(column), whole(row)});
}

}  // namespace

PlanarSampler::PlanarSampler(const std::vector<std::vector<Place>>& loops, SizeBeside size) : size_(std::move(size)) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec2 low{infinity, infinity}, high{-infinity, -infinity};
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2& p = loop[i].at;
      edges_.push_back({p, loop[(i + 1) % loop.size()].at, loop[i].size});
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  is_along_x_ = high.x - low.x > high.y - low.y;
  low_ = along(low);
  rows_.resize(std::clamp<std::size_t>(edges_.size() / 2, 1, 4096));
  strip_ = std::max(along(high) - low_, std::numeric_limits<double>::min()) / static_cast<double>(rows_.size());
  for (Index e = 0; e < edges_.size(); ++e) {
    enter(e, edges_[e], rows_);
    add(edges_[e].a, edges_[e].size);
  }
}

std::size_t PlanarSampler::row(double at) const {
  return static_cast<std::size_t>(std::clamp((at - low_) / strip_, 0.0, static_cast<double>(rows_.size() - 1)));
}

void PlanarSampler::enter(Index e, const Edge& edge, std::vector<std::vector<Index>>& rows) const {
  const auto [first, last] = std::minmax({row(along(edge.a)), row(along(edge.b))});
  for (std::size_t r = first; r <= last; ++r) rows[r].push_back(e);
}

void PlanarSampler::block(const Place& a, const Place& b) {
  block(a);
  block(b);
  if (inner_rows_.empty()) inner_rows_.resize(rows_.size());
  inner_edges_.push_back({a.at, b.at, a.size});
  enter(static_cast<Index>(inner_edges_.size() - 1), inner_edges_.back(), inner_rows_);
}

void PlanarSampler::add(const Vec2& p, double size) {
  const int number = level_of(size);
  auto level =
      std::lower_bound(levels_.begin(), levels_.end(), number, [](const Level& l, int n) { return l.number < n; });
  if (level == levels_.end() || level->number != number)
    level = levels_.insert(level, {number, std::ldexp(1.0, number + 1), {}});
  level->cells[key(std::floor(p.x / level->cell), std::floor(p.y / level->cell))].push_back(p);
}

bool PlanarSampler::is_inside(const Vec2& p) const {
  const double at = along(p);
  if (!(at >= low_)) return false;
  const auto r = static_cast<std::size_t>((at - low_) / strip_);
  if (r >= rows_.size()) return false;
  bool inside = false;
  for (const Index e : rows_[r]) {
    const auto& [a, b, size] = edges_[e];
    if ((along(a) > at) != (along(b) > at) &&
        across(p) < across(a) + (at - along(a)) / (along(b) - along(a)) * (across(b) - across(a)))
      inside = !inside;
  }
  return inside;
}

/// Returns whether p is far enough from all points. Sizes vary slowly, so points with a much smaller size cannot be
/// near and are not examined.
bool PlanarSampler::is_free(const Vec2& p, double size) const {
  const double radius = spacing_ratio * size, limit = radius * radius;
  const int least = level_of(size) - 2;
  for (const auto& [number, cell, cells] : levels_) {
    if (number < least) continue;
    const double last_column = std::floor((p.x + radius) / cell), last_row = std::floor((p.y + radius) / cell);
    for (double column = std::floor((p.x - radius) / cell); column <= last_column; ++column)
      for (double row = std::floor((p.y - radius) / cell); row <= last_row; ++row) {
        const auto at = cells.find(key(column, row));
        if (at == cells.end()) continue;
        for (const Vec2& q : at->second)
          if (squared_distance(p, q) < limit) return false;
      }
  }
  return true;
}

bool PlanarSampler::is_clear_of(const std::vector<Edge>& edges, const std::vector<std::vector<Index>>& rows,
                                const Vec2& p, double radius) const {
  if (rows.empty()) return true;
  const double limit = radius * radius;
  for (std::size_t r = row(along(p) - radius), last = row(along(p) + radius); r <= last; ++r)
    for (const Index e : rows[r])
      if (squared_distance(p, edges[e].a, edges[e].b) < limit) return false;
  return true;
}

bool PlanarSampler::take(const Vec2& p, const Place& from) {
  if (!is_inside(p)) return false;
  const double size = size_(p, from);
  if (!is_free(p, size)) return false;
  if (!is_clear_of(edges_, rows_, p, edge_ratio * size) ||
      !is_clear_of(inner_edges_, inner_rows_, p, edge_ratio * size))
    return false;
  add(p, size);
  taken_.push_back(p);
  const double l = std::sqrt(squared_distance(p, from.at));
  seeds_.push_back({{p, size}, {(p.x - from.at.x) / l, (p.y - from.at.y) / l}});
  return true;
}

void PlanarSampler::advance(unsigned n_directions, double distance) {
  std::vector<Vec2> turns;
  for (unsigned i = 0; i < n_directions; ++i) {
    const double angle = i * 2 * pi / n_directions;
    turns.push_back({std::cos(angle), std::sin(angle)});
  }
  for (std::size_t k = 0; k < seeds_.size(); ++k) {
    const auto [place, d] = seeds_[k];
    const double size = place.size;
    for (const Vec2& turn : turns) {
      const Vec2 direction{turn.x * d.x - turn.y * d.y, turn.y * d.x + turn.x * d.y};
      const Vec2 nearest = plus(place.at, distance * size, direction);
      if (!is_inside(nearest) || !is_free(nearest, surely_crowded * size)) continue;
      // Mean of the target sizes at both ends of the new edge, but at least the size at its start.
      const double reach = 0.5 * (size + std::max(size, size_(nearest, place)));
      take(plus(place.at, distance * reach, direction), place);
    }
  }
}

std::vector<Vec2> PlanarSampler::run() {
  // Adds points first beside the edges of the polygon's border, then around each accepted point, then where one fits.
  for (const auto& [a, b, size_at_a] : edges_) {
    const Vec2 middle{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
    const double l = std::sqrt(squared_distance(a, b)), size = size_(middle, {a, size_at_a});
    if (!(l > 0)) continue;
    const double height = std::sqrt(std::max(size * size - 0.25 * l * l, 0.5 * size * size));
    take(plus(middle, height / l, {a.y - b.y, b.x - a.x}), {a, size_at_a});
  }
  advance(6, 1.0);
  for (const auto& [a, b, size] : edges_)
    if (const double l = std::sqrt(squared_distance(a, b)); l > 0)
      seeds_.push_back({{a, size}, {(b.x - a.x) / l, (b.y - a.y) / l}});
  advance(12, 0.95);
  return taken_;
}

}  // namespace geomesh::remesh
