// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/sheets/closing_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace geomesh::geomodel {
namespace {

// Largest fraction of an edge's length, from the pinch-out line, at which the edge is cut.
constexpr double most_of_edge = 0.5;

using Edge = std::pair<VertexIndex, VertexIndex>;  // the lesser first

Edge edge_of(VertexIndex a, VertexIndex b) { return {std::min(a, b), std::max(a, b)}; }

/// The row of triangles along pinch-out lines in which the unit between a pair of neighbouring horizons closes.
class ClosingRow {
 public:
  ClosingRow(MapSheets& sheets, const MapSamples& samples, const SheetOptions& options, double width, std::size_t pair)
      : sheets_(sheets), samples_(samples), options_(options), width_(width), bit_(MergedPairs{1} << pair) {}

  void cut() {
    mark_lines();
    join_pairs_of_edges();
    const std::size_t n = sheets_.triangles.size();
    for (std::size_t f = 0; f < n; ++f)
      if (!(sheets_.merged[f] & bit_)) cut(f);
  }

 private:
  void mark_lines() {
    on_line_.assign(sheets_.points.size(), false);
    for (std::size_t f = 0; f < sheets_.triangles.size(); ++f)
      if (sheets_.merged[f] & bit_)
        for (const VertexIndex v : sheets_.triangles[f]) on_line_[v] = true;
    // For each edge: whether the pair of horizons is merged in a triangle beside it, and whether it is separate in one.
    std::map<Edge, std::array<bool, 2>> sides;
    for (std::size_t f = 0; f < sheets_.triangles.size(); ++f) {
      const Triangle& t = sheets_.triangles[f];
      for (std::size_t i = 0; i < 3; ++i)
        if (on_line_[t[i]] && on_line_[t[(i + 1) % 3]])
          sides[edge_of(t[i], t[(i + 1) % 3])][sheets_.merged[f] & bit_ ? 0 : 1] = true;
    }
    for (const auto& [edge, side] : sides) {
      if (!side[0] || !side[1]) continue;
      along_line_[edge.first].push_back(edge.second);
      along_line_[edge.second].push_back(edge.first);
    }
  }

  /// Returns the distance of point q from the pinch-out line through vertex `from`. Only the line's edges at `from` on
  /// the side of q count; if there are none, it is the distance from the vertex.
  double distance_from_line(VertexIndex from, const Vec2& q) const {
    const Vec2& p = sheets_.points[from];
    const double dx = q.x - p.x, dy = q.y - p.y;
    double least = std::hypot(dx, dy);
    const auto line = along_line_.find(from);
    if (line == along_line_.end()) return least;
    for (const VertexIndex v : line->second) {
      const double ux = sheets_.points[v].x - p.x, uy = sheets_.points[v].y - p.y;
      if (ux * dx + uy * dy > 0) least = std::min(least, std::abs(ux * dy - uy * dx) / std::hypot(ux, uy));
    }
    return least;
  }

  bool is_cut(VertexIndex a, VertexIndex b) const { return on_line_[a] != on_line_[b]; }

  /// Collects for each edge the pairs of horizons merged in a triangle beside it, hence merged where the edge is cut.
  void join_pairs_of_edges() {
    for (std::size_t f = 0; f < sheets_.triangles.size(); ++f) {
      const Triangle& t = sheets_.triangles[f];
      for (std::size_t i = 0; i < 3; ++i)
        if (is_cut(t[i], t[(i + 1) % 3])) merged_beside_[edge_of(t[i], t[(i + 1) % 3])] |= sheets_.merged[f];
    }
  }

  VertexIndex cut_of(VertexIndex a, VertexIndex b) {
    const Edge edge = edge_of(a, b);
    if (const auto at = cuts_.find(edge); at != cuts_.end()) return at->second;
    const VertexIndex from = on_line_[a] ? a : b, to = on_line_[a] ? b : a;
    const Vec2 p = sheets_.points[from], q = sheets_.points[to];
    const double length = std::hypot(q.x - p.x, q.y - p.y);
    const double t = std::min(most_of_edge, width_ / distance_from_line(from, q));
    const auto v = static_cast<VertexIndex>(sheets_.points.size());
    sheets_.points.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    std::vector<double> given(sheets_.n_horizons);
    samples_.fitted_heights(sheets_.points.back(), fit_of_edge * length, given);
    for (std::size_t k = 0; k < sheets_.n_horizons; ++k) {
      const double on_edge = (1 - t) * sheets_.height(from, k) + t * sheets_.height(to, k);
      sheets_.heights.push_back(std::isnan(on_edge) || std::isnan(given[k]) ? on_edge : given[k]);
    }
    const std::span<double> heights(sheets_.heights.data() + v * sheets_.n_horizons, sheets_.n_horizons);
    settle_column(heights, merged_beside_.at(edge), options_.keepers, options_.gap);
    cuts_.emplace(edge, v);
    return v;
  }

  /// Cuts a triangle with one or two vertices on the pinch-out line across the two sides that leave the line.
  void cut(std::size_t f) {
    const Triangle t = sheets_.triangles[f];
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexIndex lone = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3];
      if (!is_cut(lone, b) || !is_cut(lone, c)) continue;
      const VertexIndex to_b = cut_of(lone, b), to_c = cut_of(lone, c);
      sheets_.triangles[f] = {lone, to_b, to_c};
      if (distance(to_b, c) < distance(b, to_c)) {
        add({to_b, b, c}, f);
        add({to_b, c, to_c}, f);
      } else {
        add({to_b, b, to_c}, f);
        add({b, c, to_c}, f);
      }
      return;
    }
  }

  void add(const Triangle& t, std::size_t like) {
    sheets_.triangles.push_back(t);
    sheets_.merged.push_back(sheets_.merged[like]);
  }

  double distance(VertexIndex a, VertexIndex b) const {
    return std::hypot(sheets_.points[a].x - sheets_.points[b].x, sheets_.points[a].y - sheets_.points[b].y);
  }

  MapSheets& sheets_;
  const MapSamples& samples_;
  const SheetOptions& options_;
  double width_;
  MergedPairs bit_;
  // whether each point that existed before edges were cut lies on the pinch-out line; cut edges have only such ends
  std::vector<bool> on_line_;
  std::map<VertexIndex, std::vector<VertexIndex>> along_line_;
  std::map<Edge, MergedPairs> merged_beside_;
  std::map<Edge, VertexIndex> cuts_;
};

}  // namespace

void close_units(MapSheets& sheets, const MapSamples& samples, const SheetOptions& options, double width) {
  for (std::size_t pair = 0; pair + 1 < sheets.n_horizons; ++pair)
    ClosingRow(sheets, samples, options, width, pair).cut();
}

}  // namespace geomesh::geomodel
