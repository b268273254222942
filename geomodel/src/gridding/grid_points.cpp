// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolates surfaces from points, declared in geomesh/geomodel/gridding.hpp.
#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "geomesh/core/delaunay.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/core/planar_delaunay.hpp"
#include "gridding/graph.hpp"
#include "gridding/thin_plate.hpp"
#include "naming/sums.hpp"
#include "readers/grids/grid.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::size_t default_most_nodes = 40'000, most_nodes = 1'000'000;
/// Least smoothing length as a share of the grid spacing, because the grid cannot represent smaller features.
constexpr double least_smoothing = 0.1;

void require_area(const std::vector<Vec3>& q) {
  if (q.size() < 3)
    throw Error(ErrorKind::invalid_input,
                "a surface needs at least three points, and there are " + std::to_string(q.size()));
  Box3 b;
  for (const Vec3& p : q) b.add(p);
  const double scale = std::max(b.max.x - b.min.x, b.max.y - b.min.y);
  const auto farthest = std::max_element(q.begin(), q.end(), [&](const Vec3& a, const Vec3& c) {
    return std::hypot(a.x - q[0].x, a.y - q[0].y) < std::hypot(c.x - q[0].x, c.y - q[0].y);
  });
  double off_line = 0;
  const double length = std::hypot(farthest->x - q[0].x, farthest->y - q[0].y);
  for (const Vec3& p : q)
    off_line =
        std::max(off_line, std::abs((farthest->x - q[0].x) * (p.y - q[0].y) - (farthest->y - q[0].y) * (p.x - q[0].x)) /
                               (length > 0 ? length : 1));
  if (!(off_line > 1e-9 * scale))
    throw Error(ErrorKind::invalid_input,
                "all points lie on one line (seen along the direction in which the surface is a graph): no surface can "
                "be made from them");
}

PlateGrid plate_over(const Box3& bounds, std::size_t n_points, double asked_spacing) {
  const double width = bounds.max.x - bounds.min.x, height = bounds.max.y - bounds.min.y;
  double spacing = asked_spacing;
  if (!(spacing > 0)) {
    const double n = static_cast<double>(std::min(n_points, default_most_nodes));
    spacing = std::min(std::sqrt(width * height / n), std::min(width, height) / 4);
    spacing = std::max(spacing, std::sqrt(width * height / static_cast<double>(default_most_nodes)));
  }
  const double n_u = std::ceil(width / spacing) + 1, n_v = std::ceil(height / spacing) + 1;
  if (n_u * n_v > static_cast<double>(most_nodes)) {
    throw Error(ErrorKind::usage, "gridding.spacing " + std::to_string(spacing) + " makes " +
                                      std::to_string(static_cast<long long>(n_u)) + " by " +
                                      std::to_string(static_cast<long long>(n_v)) + " nodes; at most " +
                                      std::to_string(most_nodes) + " are offered: give a greater spacing");
  }
  PlateGrid grid{bounds.min.x,
                 bounds.min.y,
                 1,
                 1,
                 std::max<std::size_t>(static_cast<std::size_t>(n_u), 3),
                 std::max<std::size_t>(static_cast<std::size_t>(n_v), 3)};
  grid.du = width / static_cast<double>(grid.n_u - 1);
  grid.dv = height / static_cast<double>(grid.n_v - 1);
  return grid;
}

/// Points sorted into square buckets, used to test whether a point lies within a fixed distance of (u, v).
class Nearness {
 public:
  Nearness(const std::vector<Vec3>& points, double distance) : points_(points), distance_(distance) {
    for (std::size_t i = 0; i < points.size(); ++i) buckets_[key(cell(points[i].x), cell(points[i].y))].push_back(i);
  }
  bool any_near(double u, double v) const {
    for (std::int64_t j = cell(v) - 1; j <= cell(v) + 1; ++j)
      for (std::int64_t i = cell(u) - 1; i <= cell(u) + 1; ++i)
        if (const auto it = buckets_.find(key(i, j)); it != buckets_.end())
          for (const std::size_t p : it->second)
            if (std::hypot(points_[p].x - u, points_[p].y - v) <= distance_) return true;
    return false;
  }

 private:
  std::int64_t cell(double x) const { return static_cast<std::int64_t>(std::floor(x / distance_)); }
  static std::uint64_t key(std::int64_t i, std::int64_t j) {
    return static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15ULL ^ static_cast<std::uint64_t>(j);
  }
  const std::vector<Vec3>& points_;
  double distance_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> buckets_;
};

void make_plate(const std::vector<Vec3>& q, const GriddingSpec& spec, const Box3& bounds, GriddedSurface& made) {
  const PlateGrid grid = plate_over(bounds, q.size(), spec.spacing);
  made.spacing = std::max(grid.du, grid.dv);
  made.smoothing = std::max(spec.smoothing, least_smoothing * made.spacing);
  const std::vector<double> heights = fit_thin_plate(grid, q, made.smoothing);
  NodeLattice lattice{grid.n_u, grid.n_v, {}};
  for (std::size_t j = 0; j < grid.n_v; ++j)
    for (std::size_t i = 0; i < grid.n_u; ++i)
      lattice.nodes.push_back({grid.u0 + static_cast<double>(i) * grid.du, grid.v0 + static_cast<double>(j) * grid.dv,
                               heights[j * grid.n_u + i]});
  if (spec.max_distance > 0) {
    const Nearness nearness(q, spec.max_distance);
    for (Vec3& node : lattice.nodes)
      if (!nearness.any_near(node.x, node.y)) node.z = std::numeric_limits<double>::quiet_NaN();
  }
  std::size_t n_left_out = 0;
  // The grid's cells are divided into triangles along the same diagonals as in the thin-plate fit.
  made.surface = triangulate_lattice(lattice, Diagonal::from_first, n_left_out);
}

void make_triangulation(const std::vector<Vec3>& q, const GriddingSpec& spec, GriddedSurface& made) {
  std::vector<Vec2> map;
  for (const Vec3& p : q) map.push_back({p.x, p.y});
  const DelaunayTriangulation delaunay = delaunay_triangulation(map);
  made.surface.points = q;
  const TriMesh& mesh = delaunay.mesh;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c) {
    if (!mesh.is_live(c) || mesh.has_vertex(c, infinite_vertex)) continue;
    const auto& v = mesh.vertices(c);
    const Triangle t{v[0], v[1], v[2]};
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, std::hypot(q[t[k]].x - q[t[(k + 1) % 3]].x, q[t[k]].y - q[t[(k + 1) % 3]].y));
    if (spec.max_distance > 0 && longest > spec.max_distance) continue;
    made.surface.triangles.push_back(t);
  }
  std::sort(made.surface.triangles.begin(), made.surface.triangles.end());
}

void measure_residuals(const std::vector<Vec3>& points, const std::vector<Vec3>& q, GriddedSurface& made) {
  const TriangleFinder finder(made.surface.points, made.surface.triangles);
  CompensatedSum squares;
  std::size_t n = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const auto height = finder.height(q[i].x, q[i].y);
    if (!height) {
      ++made.n_outside;
      continue;
    }
    const double residual = *height - q[i].z;
    squares.add(residual * residual);
    ++n;
    if (std::abs(residual) > std::abs(made.largest_residual)) {
      made.largest_residual = residual;
      made.largest_place = points[i];
    }
  }
  if (n > 0) made.rms_residual = std::sqrt(squares.value() / static_cast<double>(n));
}

}  // namespace

GriddedSurface grid_points(const std::vector<Vec3>& points, const GriddingSpec& spec, GraphOver over, const Box3* box) {
  const Frame frame = graph_frame(points, over);
  std::vector<Vec3> q;
  q.reserve(points.size());
  Box3 bounds;
  for (const Vec3& p : points) {
    q.push_back(frame.to_frame(p));
    bounds.add(q.back());
  }
  require_area(q);
  if (spec.to_box && box && frame.is_map) {
    bounds.add(box->min);
    bounds.add(box->max);
  }
  GriddedSurface made;
  made.n_points = points.size();
  if (spec.method == GriddingSpec::Method::thin_plate) {
    make_plate(q, spec, bounds, made);
  } else {
    make_triangulation(q, spec, made);
  }
  if (made.surface.triangles.empty())
    throw Error(ErrorKind::invalid_input,
                "no triangle is left of the surface: gridding.max_distance is shorter than the points are apart");
  made.n_nodes = made.surface.points.size();
  measure_residuals(points, q, made);
  for (Vec3& p : made.surface.points) p = frame.to_model(p);
  return made;
}

}  // namespace geomesh::geomodel
