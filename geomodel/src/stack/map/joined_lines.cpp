// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/map/joined_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace geomesh::geomodel {
namespace {

double distance(Vec2 a, Vec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Points sorted by ascending x, for range queries.
class SortedPlaces {
 public:
  explicit SortedPlaces(std::vector<Vec2> places) : places_(std::move(places)), order_(places_.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return places_[a].x != places_[b].x ? places_[a].x < places_[b].x : a < b;
    });
  }
  const std::vector<Vec2>& places() const { return places_; }
  /// Calls `visit` with the index of each point whose x is in [from, to].
  template <class F>
  void for_each(double from, double to, F&& visit) const {
    auto at = std::lower_bound(order_.begin(), order_.end(), from,
                               [&](std::size_t row, double x) { return places_[row].x < x; });
    for (; at != order_.end() && places_[*at].x <= to; ++at) visit(*at);
  }

 private:
  std::vector<Vec2> places_;
  std::vector<std::size_t> order_;
};

/// Moves each vertex of the lines onto the first vertex within reach that is itself not moved.
void merge_vertices(std::vector<std::vector<Vec2>>& lines, double reach) {
  std::vector<Vec2> all;
  for (const std::vector<Vec2>& line : lines) all.insert(all.end(), line.begin(), line.end());
  const SortedPlaces sorted(std::move(all));
  const std::vector<Vec2>& places = sorted.places();
  std::vector<std::size_t> stays(places.size());
  for (std::size_t v = 0; v < places.size(); ++v) {
    stays[v] = v;
    sorted.for_each(places[v].x - reach, places[v].x + reach, [&](std::size_t other) {
      if (other < stays[v] && stays[other] == other && distance(places[v], places[other]) <= reach) stays[v] = other;
    });
  }
  std::size_t v = 0;
  for (std::vector<Vec2>& line : lines) {
    for (Vec2& p : line) p = places[stays[v++]];
    line.erase(std::unique(line.begin(), line.end()), line.end());
  }
}

/// Appends the segment pq to a line, routed through the points within reach of it between its ends.
void lead_through(Vec2 p, Vec2 q, const SortedPlaces& sorted, double reach, std::vector<Vec2>& line) {
  const double length = distance(p, q);
  const Vec2 along{(q.x - p.x) / length, (q.y - p.y) / length};
  std::vector<std::pair<double, Vec2>> between;
  sorted.for_each(std::min(p.x, q.x) - reach, std::max(p.x, q.x) + reach, [&](std::size_t row) {
    const Vec2 m = sorted.places()[row], off{m.x - p.x, m.y - p.y};
    const double at = off.x * along.x + off.y * along.y;
    if (at > 0 && at < length && m != p && m != q && std::abs(off.x * along.y - off.y * along.x) <= reach)
      between.emplace_back(at, m);
  });
  std::sort(between.begin(), between.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first
                              : (a.second.x != b.second.x ? a.second.x < b.second.x : a.second.y < b.second.y);
  });
  for (const auto& [at, m] : between)
    if (line.back() != m) line.push_back(m);
  line.push_back(q);
}

}  // namespace

std::vector<std::vector<Vec2>> join_lines(std::vector<std::vector<Vec2>> lines, double reach) {
  merge_vertices(lines, reach);
  std::vector<Vec2> all;
  for (const std::vector<Vec2>& line : lines) all.insert(all.end(), line.begin(), line.end());
  const auto before = [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::sort(all.begin(), all.end(), before);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  const SortedPlaces sorted(std::move(all));
  std::vector<std::vector<Vec2>> joined;
  for (const std::vector<Vec2>& line : lines) {
    if (line.size() < 2) continue;
    joined.push_back({line.front()});
    for (std::size_t i = 1; i < line.size(); ++i) lead_through(line[i - 1], line[i], sorted, reach, joined.back());
  }
  return joined;
}

}  // namespace geomesh::geomodel
