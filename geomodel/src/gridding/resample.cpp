// SPDX-License-Identifier: GPL-3.0-or-later
// Remeshes a surface with edges of one length, declared in geomesh/geomodel/gridding.hpp.
#include <algorithm>
#include <cmath>

#include "geomesh/core/error.hpp"
#include "gridding/graph.hpp"
#include "naming/sums.hpp"
#include "rules/planar/planar_fill.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double least_corner_degrees = 30, most_triangles = 1e7;

[[noreturn]] void refuse(const TriangulatedSurface& surface, const std::string& why) {
  throw Error(ErrorKind::usage, "surface " + surface.name + " cannot be resampled: " + why +
                                    "; leave out 'resample' or remake it with other tools");
}

double map_area(const std::vector<Vec3>& points, const Triangle& t) {
  const Vec3 a = points[t[1]] - points[t[0]], b = points[t[2]] - points[t[0]];
  return 0.5 * (a.x * b.y - a.y * b.x);
}

/// Returns the area of the surface's projection onto the plane in which it is remeshed. `q` are its points in
/// coordinates of that plane. Throws if the projected triangles are not all oriented alike.
double graph_area(const TriangulatedSurface& surface, const std::vector<Vec3>& q) {
  CompensatedSum area;
  std::size_t n_left = 0, n_right = 0;
  for (const Triangle& t : surface.triangles) {
    const double a = map_area(q, t);
    n_left += a > 0;
    n_right += a < 0;
    area.add(std::abs(a));
  }
  if (n_left > 0 && n_right > 0)
    refuse(surface, "it is folded or upright somewhere, or its triangles are oriented differently");
  return area.value();
}

bool is_corner(const Vec3& before, const Vec3& at, const Vec3& after) {
  const Vec3 a = at - before, b = after - at;
  const double scale = norm(a) * norm(b);
  return scale > 0 && dot(a, b) < std::cos(least_corner_degrees * 3.14159265358979323846 / 180) * scale;
}

/// Appends points that divide a polyline into equal parts, each about `length` long, without the polyline's last point.
void divide(const std::vector<Vec3>& line, double length, std::size_t least_parts, std::vector<Vec3>& out) {
  std::vector<double> at{0};
  for (std::size_t i = 1; i < line.size(); ++i) at.push_back(at.back() + norm(line[i] - line[i - 1]));
  const auto n_parts = std::max(least_parts, static_cast<std::size_t>(std::max(1.0, std::round(at.back() / length))));
  std::size_t k = 0;
  for (std::size_t i = 0; i < n_parts; ++i) {
    const double s = at.back() * static_cast<double>(i) / static_cast<double>(n_parts);
    while (k + 2 < at.size() && at[k + 1] <= s) ++k;
    const double step = at[k + 1] - at[k], t = step > 0 ? (s - at[k]) / step : 0;
    out.push_back(i == 0 ? line.front() : line[k] + t * (line[k + 1] - line[k]));
  }
}

/// Returns a closed line after subdividing the lines between its corners, which are kept.
std::vector<Vec3> divide_loop(const std::vector<Vec3>& loop, double length) {
  std::vector<std::size_t> corners;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i)
    if (is_corner(loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n])) corners.push_back(i);
  if (corners.empty()) corners.push_back(0);
  const std::size_t least_parts = corners.size() >= 3 ? 1 : 3;
  std::vector<Vec3> out;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const std::size_t first = corners[c], last = c + 1 < corners.size() ? corners[c + 1] : corners[0] + n;
    std::vector<Vec3> line;
    for (std::size_t i = first; i <= last; ++i) line.push_back(loop[i % n]);
    divide(line, length, least_parts, out);
  }
  return out;
}

/// Adds points of a triangular lattice inside the surface, at least about half of `length` away from its borders.
void add_inside(const TriangleFinder& finder, const Box3& bounds, double length, std::vector<Vec3>& points) {
  const std::size_t n_border = points.size();
  const auto cell = [&](double x, double low) { return static_cast<std::int64_t>(std::floor((x - low) / length)); };
  std::vector<std::pair<std::pair<std::int64_t, std::int64_t>, std::size_t>> border;
  for (std::size_t i = 0; i < n_border; ++i)
    border.push_back({{cell(points[i].y, bounds.min.y), cell(points[i].x, bounds.min.x)}, i});
  std::sort(border.begin(), border.end());
  const auto near_border = [&](double u, double v) {
    const std::int64_t i = cell(u, bounds.min.x), j = cell(v, bounds.min.y);
    for (std::int64_t row = j - 1; row <= j + 1; ++row) {
      auto it = std::lower_bound(border.begin(), border.end(), std::pair(std::pair(row, i - 1), std::size_t{0}));
      for (; it != border.end() && it->first.first == row && it->first.second <= i + 1; ++it)
        if (std::hypot(points[it->second].x - u, points[it->second].y - v) < 0.6 * length) return true;
    }
    return false;
  };
  const double step = length * std::sqrt(0.75);
  std::size_t row = 0;
  for (double v = bounds.min.y + 0.5 * step; v < bounds.max.y; v += step, ++row) {
    for (double u = bounds.min.x + (row % 2 == 0 ? 0.5 : 1.0) * length; u < bounds.max.x; u += length) {
      const auto height = finder.height(u, v);
      if (height && !near_border(u, v)) points.push_back({u, v, *height});
    }
  }
}

SurfaceChange measure_change(const std::vector<Vec3>& old_points, const std::vector<Vec3>& points,
                             const std::vector<Triangle>& triangles) {
  SurfaceChange change;
  const TriangleFinder finder(points, triangles);
  CompensatedSum squares;
  std::size_t n = 0;
  for (const Vec3& p : old_points) {
    const auto height = finder.height(p.x, p.y);
    if (!height) continue;  // the old vertex is outside of the resampled surface, beside a subdivided border
    squares.add((*height - p.z) * (*height - p.z));
    change.largest_move = std::max(change.largest_move, std::abs(*height - p.z));
    ++n;
  }
  if (n > 0) change.rms_move = std::sqrt(squares.value() / static_cast<double>(n));
  change.n_triangles = triangles.size();
  return change;
}

}  // namespace

SurfaceChange resample_surface(TriangulatedSurface& surface, double length, GraphOver over) {
  const Frame frame = graph_frame(surface.points, over);
  std::vector<Vec3> q;
  Box3 bounds;
  for (const Vec3& p : surface.points) q.push_back(frame.to_frame(p));
  for (const Triangle& t : surface.triangles)
    for (const VertexIndex v : t) bounds.add(q[v]);
  const double area = graph_area(surface, q);
  if (area / (length * length) * 2.4 > most_triangles)
    refuse(surface, "edges of " + std::to_string(length) + " would make more than ten million triangles");
  const BorderLoops borders = border_loops(border_edges(surface));
  if (borders.loops.empty()) refuse(surface, "it is closed");
  if (borders.n_edges_left > 0) refuse(surface, "its borders do not close");

  std::vector<Vec3> points;
  std::vector<std::pair<Index, Index>> constraints;
  for (const std::vector<VertexIndex>& rows : borders.loops) {
    std::vector<Vec3> loop;
    for (const VertexIndex v : rows) loop.push_back(q[v]);
    const auto first = static_cast<Index>(points.size());
    for (const Vec3& p : divide_loop(loop, length)) points.push_back(p);
    const auto last = static_cast<Index>(points.size());
    for (Index i = first; i < last; ++i) constraints.emplace_back(i, i + 1 < last ? i + 1 : first);
  }
  add_inside(TriangleFinder(q, surface.triangles), bounds, length, points);
  std::vector<Vec2> map;
  for (const Vec3& p : points) map.push_back({p.x, p.y});
  const auto made = triangulate_plane(map, constraints);
  if (!made)
    refuse(surface, "its borders, divided into edges of " + std::to_string(length) + ", cross or touch each other");
  std::vector<Triangle> triangles;
  CompensatedSum new_area;
  const bool turned = !surface.triangles.empty() && map_area(q, surface.triangles.front()) < 0;
  for (const PlanarTriangle& t : *made) {
    if (t.depth % 2 == 0) continue;
    triangles.push_back({t.vertices[0], t.vertices[1], t.vertices[2]});
    new_area.add(map_area(points, triangles.back()));
    if (turned) std::swap(triangles.back()[1], triangles.back()[2]);
  }
  if (!(std::abs(new_area.value() - area) < 0.25 * area))
    refuse(surface, "parts of it lie above each other, or the requested edges are longer than its parts");
  const SurfaceChange change = measure_change(q, points, triangles);
  surface.points.clear();
  for (const Vec3& p : points) surface.points.push_back(frame.to_model(p));
  surface.triangles = std::move(triangles);
  return change;
}

}  // namespace geomesh::geomodel
