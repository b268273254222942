// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/map/map_raster.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace geomesh::geomodel {
namespace {

// Largest move of a point of a divided curve to preserve the areas beside it, as a fraction of a piece of the curve.
constexpr double most_move = 0.25;

}  // namespace

MapRaster::MapRaster(const MapBounds& bounds, double cell)
    : origin(bounds.min),
      step(cell),
      n_columns(2 + static_cast<std::size_t>((bounds.max.x - bounds.min.x) / cell)),
      n_rows(2 + static_cast<std::size_t>((bounds.max.y - bounds.min.y) / cell)),
      values(n_columns * n_rows, std::numeric_limits<double>::quiet_NaN()) {}

std::size_t MapRaster::cell_of(Vec2 p) const {
  const auto row_of = [this](double at, double from, std::size_t n) {
    return std::min(n - 1, static_cast<std::size_t>(std::max(0.0, (at - from) / step + 0.5)));
  };
  return row_of(p.y, origin.y, n_rows) * n_columns + row_of(p.x, origin.x, n_columns);
}

double MapRaster::between(Vec2 p) const {
  const auto place = [this](double at, double from, std::size_t n) {
    const double cells = std::clamp((at - from) / step, 0.0, static_cast<double>(n - 1));
    const std::size_t first = std::min(n - 2, static_cast<std::size_t>(cells));
    return std::pair(first, cells - static_cast<double>(first));
  };
  const auto [i, u] = place(p.x, origin.x, n_columns);
  const auto [j, v] = place(p.y, origin.y, n_rows);
  return (1 - v) * ((1 - u) * at(i, j) + u * at(i + 1, j)) + v * ((1 - u) * at(i, j + 1) + u * at(i + 1, j + 1));
}

namespace {

/// Calls f with each cell of the raster that shares a side with `cell`.
template <class F>
void for_neighbours(const MapRaster& r, std::size_t cell, F&& f) {
  const std::size_t i = cell % r.n_columns, j = cell / r.n_columns;
  if (i > 0) f(cell - 1);
  if (i + 1 < r.n_columns) f(cell + 1);
  if (j > 0) f(cell - r.n_columns);
  if (j + 1 < r.n_rows) f(cell + r.n_columns);
}

void smooth_line(std::vector<double>& values, std::size_t first, std::size_t n, std::size_t stride) {
  double before = values[first];
  for (std::size_t k = 0; k < n; ++k) {
    double& here = values[first + k * stride];
    const double after = k + 1 < n ? values[first + (k + 1) * stride] : here;
    const double mean = 0.25 * before + 0.5 * here + 0.25 * after;
    before = here;
    here = mean;
  }
}

/// Connects the segments of marching triangles to curves. At most two segments end on one edge of the lattice.
class CurveJoiner {
 public:
  using Edge = std::pair<std::size_t, std::size_t>;  ///< an edge of the lattice: its two cells, the smaller index first
  void add(Edge from, Vec2 p, Edge to, Vec2 q) {
    place_[from] = p;
    place_[to] = q;
    next_[from] = to;
    has_before_[to] = true;
  }
  std::vector<std::vector<Vec2>> curves() {
    std::vector<std::vector<Vec2>> result;
    std::vector<Edge> starts;
    for (const auto& [edge, to] : next_)
      if (!has_before_.contains(edge)) starts.push_back(edge);
    for (const Edge& start : starts) result.push_back(follow(start));
    while (!next_.empty()) result.push_back(follow(next_.begin()->first));
    return result;
  }

 private:
  std::vector<Vec2> follow(Edge edge) {
    std::vector<Vec2> curve{place_.at(edge)};
    for (auto at = next_.find(edge); at != next_.end(); at = next_.find(edge)) {
      edge = at->second;
      next_.erase(at);
      curve.push_back(place_.at(edge));
    }
    return curve;
  }
  std::map<Edge, Vec2> place_;
  std::map<Edge, Edge> next_;
  std::map<Edge, bool> has_before_;
};

/// Adds the segment of the zero curve in one counter-clockwise triangle of cell centres.
void add_crossing(const MapRaster& r, const std::array<std::size_t, 3>& cells, CurveJoiner& joiner) {
  const auto centre = [&](std::size_t cell) { return r.centre(cell % r.n_columns, cell / r.n_columns); };
  CurveJoiner::Edge ends[2];
  Vec2 places[2];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t a = cells[i], b = cells[(i + 1) % 3];
    const double va = r.values[a], vb = r.values[b];
    if ((va < 0) == (vb < 0)) continue;
    const double t = va / (va - vb);
    const Vec2 p = centre(a), q = centre(b);
    // The zero curve leaves the triangle through the side along which values change from negative to positive.
    const std::size_t end = va < 0 ? 0 : 1;
    ends[end] = {std::min(a, b), std::max(a, b)};
    places[end] = {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
  }
  joiner.add(ends[0], places[0], ends[1], places[1]);
}

}  // namespace

void fill_from_neighbours(MapRaster& raster) {
  std::vector<std::size_t> front, next;
  for (std::size_t c = 0; c < raster.size(); ++c)
    if (!std::isnan(raster.values[c])) front.push_back(c);
  while (!front.empty()) {
    next.clear();
    for (const std::size_t c : front)
      for_neighbours(raster, c, [&](std::size_t n) {
        if (!std::isnan(raster.values[n])) return;
        raster.values[n] = raster.values[c];
        next.push_back(n);
      });
    front.swap(next);
  }
}

void smooth(MapRaster& raster, int passes) {
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t j = 0; j < raster.n_rows; ++j)
      smooth_line(raster.values, j * raster.n_columns, raster.n_columns, 1);
    for (std::size_t i = 0; i < raster.n_columns; ++i) smooth_line(raster.values, i, raster.n_rows, raster.n_columns);
  }
}

CellGroups groups_of(const MapRaster& raster, bool below) {
  CellGroups groups;
  groups.group.assign(raster.size(), no_index);
  std::vector<std::size_t> stack;
  for (std::size_t start = 0; start < raster.size(); ++start) {
    if ((raster.values[start] < 0) != below || groups.group[start] != no_index) continue;
    const auto g = static_cast<Index>(groups.n_cells.size());
    groups.n_cells.push_back(0);
    groups.least.push_back(raster.values[start]);
    groups.greatest.push_back(raster.values[start]);
    groups.group[start] = g;
    stack.push_back(start);
    while (!stack.empty()) {
      const std::size_t c = stack.back();
      stack.pop_back();
      ++groups.n_cells[g];
      groups.least[g] = std::min(groups.least[g], raster.values[c]);
      groups.greatest[g] = std::max(groups.greatest[g], raster.values[c]);
      for_neighbours(raster, c, [&](std::size_t n) {
        if ((raster.values[n] < 0) != below || groups.group[n] != no_index) return;
        groups.group[n] = g;
        stack.push_back(n);
      });
    }
  }
  return groups;
}

std::vector<std::vector<Vec2>> zero_curves(const MapRaster& r) {
  CurveJoiner joiner;
  const auto is_cut = [&](const std::array<std::size_t, 3>& t) {
    const bool a = r.values[t[0]] < 0;
    return a != (r.values[t[1]] < 0) || a != (r.values[t[2]] < 0);
  };
  for (std::size_t j = 0; j + 1 < r.n_rows; ++j)
    for (std::size_t i = 0; i + 1 < r.n_columns; ++i) {
      const std::size_t a = j * r.n_columns + i, b = a + 1, c = b + r.n_columns, d = a + r.n_columns;
      const std::array<std::size_t, 3> lower{a, b, c}, upper{a, c, d};
      for (const auto* t : {&lower, &upper})
        if (is_cut(*t)) add_crossing(r, *t, joiner);
    }
  return joiner.curves();
}

namespace {

/// Returns twice the area enclosed by a chain of points and its closing segment, positive if it is counter-clockwise.
double twice_area(const std::vector<Vec2>& chain) {
  double sum = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Vec2 &p = chain[i], &q = chain[(i + 1) % chain.size()], &from = chain[0];
    sum += (p.x - from.x) * (q.y - from.y) - (p.y - from.y) * (q.x - from.x);
  }
  return sum;
}

Vec2 on_piece(const Vec2& p, const Vec2& q, double t) { return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}; }

/// A point of a divided curve: on the original curve's segment that ends at point `at`, at a fraction of it.
struct Division {
  std::size_t at;
  double share;
};

/// Moves the points of a curve made of longer pieces, so that the areas on its sides equal those of the original curve.
void keep_area(std::vector<Vec2>& divided, const std::vector<Division>& from, const std::vector<Vec2>& curve,
               double length) {
  const std::size_t n = divided.size() - 1;  // pieces
  const bool closed = n > 2 && divided.front() == divided.back();
  std::vector<double> twice(n), lengths(n);
  const auto of = [&](const Division& d) { return on_piece(curve[d.at - 1], curve[d.at], d.share); };
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<Vec2> chain{divided[k + 1], divided[k], of(from[k])};
    for (std::size_t i = from[k].at; i < from[k + 1].at; ++i) chain.push_back(curve[i]);
    chain.push_back(of(from[k + 1]));
    // Twice the area between a segment and the curve it replaces, positive if the curve is on the segment's left.
    twice[k] = -twice_area(chain);
    lengths[k] = std::hypot(divided[k + 1].x - divided[k].x, divided[k + 1].y - divided[k].y);
  }
  const std::vector<Vec2> before = divided;
  for (std::size_t k = closed ? 0 : 1; k < n; ++k) {
    const std::size_t last = k == 0 ? n - 1 : k - 1;
    const Vec2 along{before[k + 1].x - before[last].x, before[k + 1].y - before[last].y};
    const double norm = std::hypot(along.x, along.y), most = most_move * length;
    if (!(norm > 0)) continue;
    const double move = std::clamp(0.5 * (twice[last] + twice[k]) / (lengths[last] + lengths[k]), -most, most);
    divided[k] = {before[k].x - move * along.y / norm, before[k].y + move * along.x / norm};
  }
  if (closed) divided.back() = divided.front();
}

}  // namespace

std::vector<Vec2> smooth_curve(const std::vector<Vec2>& curve, double length) {
  constexpr int passes = 4;
  std::vector<Vec2> smoothed = curve;
  const std::size_t n = curve.size();
  const bool closed = n > 3 && curve.front() == curve.back();
  for (int pass = 0; pass < passes && n > 2; ++pass) {
    const std::vector<Vec2> before = smoothed;
    const auto mean = [&](const Vec2& a, const Vec2& b, const Vec2& c) {
      return Vec2{0.25 * a.x + 0.5 * b.x + 0.25 * c.x, 0.25 * a.y + 0.5 * b.y + 0.25 * c.y};
    };
    for (std::size_t i = 1; i + 1 < n; ++i) smoothed[i] = mean(before[i - 1], before[i], before[i + 1]);
    if (closed) smoothed[0] = smoothed[n - 1] = mean(before[n - 2], before[0], before[1]);
  }
  std::vector<double> along{0};
  for (std::size_t i = 1; i < n; ++i)
    along.push_back(along.back() + std::hypot(smoothed[i].x - smoothed[i - 1].x, smoothed[i].y - smoothed[i - 1].y));
  const auto n_pieces = static_cast<std::size_t>(std::max(closed ? 3.0 : 1.0, std::round(along.back() / length)));
  std::vector<Vec2> divided{smoothed.front()};
  std::vector<Division> from{{1, 0.0}};
  std::size_t at = 1;
  for (std::size_t k = 1; k < n_pieces; ++k) {
    const double wanted = along.back() * static_cast<double>(k) / static_cast<double>(n_pieces);
    while (at + 1 < n && along[at] < wanted) ++at;
    const double span = along[at] - along[at - 1], t = span > 0 ? (wanted - along[at - 1]) / span : 0;
    divided.push_back(on_piece(smoothed[at - 1], smoothed[at], t));
    from.push_back({at, t});
  }
  divided.push_back(smoothed.back());
  from.push_back({n - 1, 1.0});
  keep_area(divided, from, curve, along.back() / static_cast<double>(n_pieces));
  return divided;
}

std::vector<Vec2> beside(const std::vector<Vec2>& curve, double left) {
  std::vector<Vec2> moved = curve;
  const std::size_t n = curve.size();
  const bool closed = n > 3 && curve.front() == curve.back();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 &before = i > 0    ? curve[i - 1]
                         : closed ? curve[n - 2]
                                  : curve[0],
               &after = i + 1 < n ? curve[i + 1]
                        : closed  ? curve[1]
                                  : curve[n - 1];
    const double dx = after.x - before.x, dy = after.y - before.y, norm = std::hypot(dx, dy);
    if (norm > 0) moved[i] = {curve[i].x - left * dy / norm, curve[i].y + left * dx / norm};
  }
  return moved;
}

}  // namespace geomesh::geomodel
