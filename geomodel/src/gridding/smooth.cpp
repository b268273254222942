// SPDX-License-Identifier: GPL-3.0-or-later
// Smooths surfaces, declared in geomesh/geomodel/gridding.hpp.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "geomesh/geomodel/gridding.hpp"
#include "naming/sums.hpp"
#include "readers/triangles/merge_points.hpp"

namespace geomesh::geomodel {
namespace {

/// A surface whose equal vertices are merged. Smoothing thus moves both sides of a seam together.
struct WeldedSurface {
  std::vector<Vec3> points;
  std::vector<VertexIndex> row;  ///< by vertex of the original surface: its vertex after merging
  std::vector<Triangle> triangles;
  std::vector<std::vector<VertexIndex>> neighbours;  ///< sorted
  std::vector<bool> fixed;  ///< points that smoothing does not move: on a border of the surface, or in no triangle
};

WeldedSurface weld(const TriangulatedSurface& surface) {
  WeldedSurface w;
  w.row = merge_equal_points(surface.points, w.points);
  w.neighbours.resize(w.points.size());
  std::vector<std::pair<VertexIndex, VertexIndex>> edges;
  for (const Triangle& given : surface.triangles) {
    const Triangle t{w.row[given[0]], w.row[given[1]], w.row[given[2]]};
    w.triangles.push_back(t);
    for (std::size_t k = 0; k < 3; ++k)
      if (t[k] != t[(k + 1) % 3]) edges.emplace_back(std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]));
  }
  std::sort(edges.begin(), edges.end());
  w.fixed.assign(w.points.size(), false);
  for (std::size_t i = 0, j; i < edges.size(); i = j) {
    for (j = i; j < edges.size() && edges[j] == edges[i];) ++j;
    const auto [a, b] = edges[i];
    w.neighbours[a].push_back(b);
    w.neighbours[b].push_back(a);
    if (j - i == 1) w.fixed[a] = w.fixed[b] = true;
  }
  return w;
}

std::vector<Vec3> vertex_normals(const WeldedSurface& w) {
  std::vector<Vec3> normals(w.points.size());
  for (const Triangle& t : w.triangles) {
    const Vec3 n = cross(w.points[t[1]] - w.points[t[0]], w.points[t[2]] - w.points[t[0]]);
    for (const VertexIndex v : t) normals[v] = normals[v] + n;
  }
  return normals;
}

/// Returns the height above the vertex, along w, of the plane fitted by least squares to the vertex and its neighbours;
/// 0 if they determine no plane.
double fitted_height(const WeldedSurface& s, VertexIndex v, const Vec3& u_axis, const Vec3& v_axis,
                     const Vec3& w_axis) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  Eigen::Vector3d r = Eigen::Vector3d::Zero();
  double scale = 0;
  for (const VertexIndex n : s.neighbours[v]) scale = std::max(scale, norm(s.points[n] - s.points[v]));
  if (!(scale > 0)) return 0;
  m(0, 0) = 1;
  for (const VertexIndex n : s.neighbours[v]) {
    const Vec3 d = (1 / scale) * (s.points[n] - s.points[v]);
    const Eigen::Vector3d a(1, dot(d, u_axis), dot(d, v_axis));
    m += a * a.transpose();
    r += dot(d, w_axis) * a;
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(m);
  return lu.rank() == 3 ? scale * lu.solve(r)[0] : 0;
}

void one_pass(WeldedSurface& w, GraphOver over) {
  const std::vector<Vec3> normals = over == GraphOver::map ? std::vector<Vec3>() : vertex_normals(w);
  std::vector<Vec3> moved = w.points;
  for (VertexIndex v = 0; v < w.points.size(); ++v) {
    if (w.fixed[v] || w.neighbours[v].size() < 3) continue;
    Vec3 u_axis{1, 0, 0}, v_axis{0, 1, 0}, w_axis{0, 0, 1};
    if (over != GraphOver::map) {
      if (!(norm(normals[v]) > 0)) continue;
      w_axis = (1 / norm(normals[v])) * normals[v];
      const Vec3 u = cross(std::abs(w_axis.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}, w_axis);
      u_axis = (1 / norm(u)) * u;
      v_axis = cross(w_axis, u_axis);
    }
    moved[v] = w.points[v] + 0.5 * fitted_height(w, v, u_axis, v_axis, w_axis) * w_axis;
  }
  w.points = std::move(moved);
}

}  // namespace

SurfaceChange smooth_surface(TriangulatedSurface& surface, int passes, GraphOver over) {
  WeldedSurface w = weld(surface);
  for (int i = 0; i < passes; ++i) one_pass(w, over);
  SurfaceChange change;
  CompensatedSum squares;
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    const Vec3& p = w.points[w.row[i]];
    const double move = norm(p - surface.points[i]);
    squares.add(move * move);
    change.largest_move = std::max(change.largest_move, move);
    surface.points[i] = p;
  }
  if (!surface.points.empty())
    change.rms_move = std::sqrt(squares.value() / static_cast<double>(surface.points.size()));
  change.n_triangles = surface.triangles.size();
  return change;
}

}  // namespace geomesh::geomodel
