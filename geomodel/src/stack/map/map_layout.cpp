// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/map/map_layout.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "stack/map/joined_lines.hpp"

namespace geomesh::geomodel {
namespace {

// Distance around constraint lines that is kept free of lattice points, as a fraction of the lattice spacing.
constexpr double room_about_lines = 0.4;
constexpr double room_on_rim = 0.3;
constexpr double shortest_edge = 0.08;  // length below which edges are collapsed, as a fraction of the lattice spacing

/// Returns the part of the segment p q within the bounds; ends that are clipped lie exactly on the bounds.
std::optional<std::pair<Vec2, Vec2>> cut_off(Vec2 p, Vec2 q, const MapBounds& b) {
  const auto at_x = [&](double x) { return Vec2{x, p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y)}; };
  const auto at_y = [&](double y) { return Vec2{p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x), y}; };
  for (int end = 0; end < 2; ++end) {
    if (p.x < b.min.x && q.x > b.min.x) p = at_x(b.min.x);
    if (p.x > b.max.x && q.x < b.max.x) p = at_x(b.max.x);
    if (p.y < b.min.y && q.y > b.min.y) p = at_y(b.min.y);
    if (p.y > b.max.y && q.y < b.max.y) p = at_y(b.max.y);
    std::swap(p, q);
  }
  if (!b.holds(p) || !b.holds(q) || p == q) return std::nullopt;
  return std::pair(p, q);
}

std::vector<std::vector<Vec2>> cut_off(const std::vector<std::vector<Vec2>>& lines, const MapBounds& bounds) {
  std::vector<std::vector<Vec2>> kept;
  for (const std::vector<Vec2>& line : lines) {
    bool joins = false;  // whether the next segment of the line continues the last kept one
    for (std::size_t i = 1; i < line.size(); ++i) {
      const auto piece = cut_off(line[i - 1], line[i], bounds);
      if (!piece) {
        joins = false;
        continue;
      }
      if (!joins) kept.push_back({piece->first});
      kept.back().push_back(piece->second);
      joins = piece->second == line[i];
    }
  }
  return kept;
}

/// Tests whether points are near constraint lines, using a grid with the lattice spacing.
class Neighbourhood {
 public:
  Neighbourhood(const MapLayout& layout, const std::vector<std::vector<Vec2>>& lines)
      : bounds_(layout.bounds), cell_(layout.lattice) {
    n_columns_ = 1 + static_cast<std::size_t>((bounds_.max.x - bounds_.min.x) / cell_);
    n_rows_ = 1 + static_cast<std::size_t>((bounds_.max.y - bounds_.min.y) / cell_);
    points_.resize(n_columns_ * n_rows_);
    for (const std::vector<Vec2>& line : lines)
      for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec2 d{line[i].x - line[i - 1].x, line[i].y - line[i - 1].y};
        const auto n = 1 + static_cast<std::size_t>(std::hypot(d.x, d.y) / (0.25 * cell_));
        for (std::size_t k = 0; k <= n; ++k) {
          const double t = static_cast<double>(k) / static_cast<double>(n);
          const Vec2 p{line[i - 1].x + t * d.x, line[i - 1].y + t * d.y};
          points_[row(p.y) * n_columns_ + column(p.x)].push_back(p);
        }
      }
  }
  bool is_near(const Vec2& p, double distance) const {
    for (std::size_t j = row(p.y - distance); j <= row(p.y + distance); ++j)
      for (std::size_t i = column(p.x - distance); i <= column(p.x + distance); ++i)
        for (const Vec2& q : points_[j * n_columns_ + i])
          if (std::hypot(p.x - q.x, p.y - q.y) < distance) return true;
    return false;
  }

 private:
  std::size_t column(double x) const {
    return std::min(n_columns_ - 1, static_cast<std::size_t>(std::max(0.0, (x - bounds_.min.x) / cell_)));
  }
  std::size_t row(double y) const {
    return std::min(n_rows_ - 1, static_cast<std::size_t>(std::max(0.0, (y - bounds_.min.y) / cell_)));
  }
  MapBounds bounds_;
  double cell_;
  std::size_t n_columns_, n_rows_;
  std::vector<std::vector<Vec2>> points_;
};

void add_rim(const MapLayout& layout, const Neighbourhood& lines, std::vector<Vec2>& points) {
  const MapBounds& b = layout.bounds;
  const Vec2 corners[4] = {b.min, {b.max.x, b.min.y}, b.max, {b.min.x, b.max.y}};
  for (std::size_t side = 0; side < 4; ++side) {
    const Vec2 p = corners[side], q = corners[(side + 1) % 4];
    const double length = std::abs(q.x - p.x) + std::abs(q.y - p.y);
    const auto n = static_cast<std::size_t>(std::max(1.0, std::round(length / layout.lattice)));
    points.push_back(p);
    for (std::size_t k = 1; k < n; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(n);
      const Vec2 m{p.x == q.x ? p.x : p.x + t * (q.x - p.x), p.y == q.y ? p.y : p.y + t * (q.y - p.y)};
      if (!lines.is_near(m, room_on_rim * layout.lattice)) points.push_back(m);
    }
  }
}

/// Adds a triangular lattice of points: rows of which every other one is shifted by half the spacing.
void add_lattice(const MapLayout& layout, const Neighbourhood& lines, std::vector<Vec2>& points) {
  const MapBounds& b = layout.bounds;
  const auto n_rows =
      static_cast<std::size_t>(std::max(1.0, std::round((b.max.y - b.min.y) / (layout.lattice * std::sqrt(0.75)))));
  const auto n_columns = static_cast<std::size_t>(std::max(1.0, std::round((b.max.x - b.min.x) / layout.lattice)));
  const double dx = (b.max.x - b.min.x) / static_cast<double>(n_columns),
               dy = (b.max.y - b.min.y) / static_cast<double>(n_rows);
  for (std::size_t j = 1; j < n_rows; ++j)
    for (std::size_t i = 0; i < n_columns; ++i) {
      const Vec2 p{b.min.x + dx * (static_cast<double>(i) + (j % 2 == 0 ? 0.0 : 0.5)),
                   b.min.y + dy * static_cast<double>(j)};
      const double to_rim = std::min(p.x - b.min.x, b.max.x - p.x);
      if (to_rim > 0.4 * dx && !lines.is_near(p, room_about_lines * layout.lattice)) points.push_back(p);
    }
}

/// Returns for each point the index of the point that replaces it, if an edge shorter than `least` connects them. Of
/// two points, a corner of the bounds is kept, otherwise one on the rim, otherwise the first. Empty if no edge is that
/// short.
std::vector<VertexIndex> merged_rows(const LinedTriangulation& t, const MapBounds& b, double least) {
  std::vector<VertexIndex> row(t.points.size());
  for (VertexIndex v = 0; v < row.size(); ++v) row[v] = v;
  const auto find = [&](VertexIndex v) {
    while (row[v] != v) v = row[v];
    return v;
  };
  const auto rank = [&](VertexIndex v) {
    const Vec2& p = t.points[v];
    return (p.x == b.min.x || p.x == b.max.x) + (p.y == b.min.y || p.y == b.max.y);
  };
  bool any = false;
  for (const Triangle& v : t.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      VertexIndex stays = find(v[i]), goes = find(v[(i + 1) % 3]);
      const Vec2 &p = t.points[stays], &q = t.points[goes];
      if (stays == goes || std::hypot(p.x - q.x, p.y - q.y) >= least) continue;
      if (rank(goes) > rank(stays) || (rank(goes) == rank(stays) && goes < stays)) std::swap(stays, goes);
      row[goes] = stays;
      any = true;
    }
  if (!any) return {};
  for (VertexIndex v = 0; v < row.size(); ++v) row[v] = find(v);
  return row;
}

/// Merges points closer than `least` because of constraint lines, and triangulates again until no such points are left.
LinedTriangulation without_short_edges(LinedTriangulation t, const MapBounds& bounds, double least) {
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds; ++round) {
    const std::vector<VertexIndex> row = merged_rows(t, bounds, least);
    if (row.empty()) break;
    std::vector<Vec2> points;
    for (VertexIndex v = 0; v < row.size(); ++v)
      if (row[v] == v) points.push_back(t.points[v]);
    std::vector<std::vector<Vec2>> lines;
    for (std::size_t f = 0; f < t.triangles.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        const VertexIndex a = row[t.triangles[f][(i + 1) % 3]], b = row[t.triangles[f][(i + 2) % 3]];
        if ((t.lined_sides[f] >> i & 1) && a < b) lines.push_back({t.points[a], t.points[b]});
      }
    t = triangulate_lines(points, lines);
  }
  return t;
}

}  // namespace

LinedTriangulation triangulate_layout(const MapLayout& layout) {
  const std::vector<std::vector<Vec2>> lines = cut_off(join_lines(layout.lines, layout.joined_within), layout.bounds);
  const Neighbourhood near_lines(layout, lines);
  std::vector<Vec2> points;
  add_rim(layout, near_lines, points);
  add_lattice(layout, near_lines, points);
  LinedTriangulation t = triangulate_lines(points, lines);
  return layout.keeps_lines ? t : without_short_edges(std::move(t), layout.bounds, shortest_edge * layout.lattice);
}

}  // namespace geomesh::geomodel
