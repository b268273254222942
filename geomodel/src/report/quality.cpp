// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geomesh/core/simplex_mesh.hpp"
#include "geomesh/geomodel/report.hpp"
#include "sets/sums.hpp"

namespace geomesh::geomodel {

namespace {

constexpr std::size_t n_worst = 10;

struct Shape {
  std::array<double, 6> dihedral;  ///< degrees
  double min_dihedral, max_dihedral, radius_ratio;
};

/// Dihedral angles from the planes' normals by atan2, which keeps its digits near 0 and 180 degrees.
Shape shape_of(const std::array<Vec3, 4>& p) {
  Shape shape{};
  std::array<Vec3, 4> normal;  // inward, length twice the face's area
  double area = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& f = face_vertices[i];
    normal[i] = cross(p[f[1]] - p[f[0]], p[f[2]] - p[f[0]]);
    area += norm(normal[i]) / 2;
  }
  for (std::size_t e = 0; e < 6; ++e) {
    // The edge between vertices i and j lies in the two faces opposite to the other two.
    const auto [i, j] = edge_vertices[e];
    std::array<std::size_t, 2> others{};
    std::size_t n = 0;
    for (std::size_t v = 0; v < 4; ++v)
      if (v != i && v != j) others[n++] = v;
    const Vec3 &m = normal[others[0]], &o = normal[others[1]];
    shape.dihedral[e] = std::atan2(norm(cross(m, o)), -dot(m, o)) * 180 / std::numbers::pi;
  }
  const auto [least, greatest] = std::minmax_element(shape.dihedral.begin(), shape.dihedral.end());
  shape.min_dihedral = *least;
  shape.max_dihedral = *greatest;
  // Circumcentre from vertex 0: (|b|^2 c x d + |c|^2 d x b + |d|^2 b x c) / (2 det).
  const Vec3 b = p[1] - p[0], c = p[2] - p[0], d = p[3] - p[0];
  const double det = dot(cross(b, c), d);
  const Vec3 top = dot(b, b) * cross(c, d) + dot(c, c) * cross(d, b) + dot(d, d) * cross(b, c);
  const double in_radius = det / (2 * area), circum_radius = norm(top) / (2 * std::abs(det));
  shape.radius_ratio = circum_radius > 0 && std::isfinite(circum_radius) ? 3 * in_radius / circum_radius : 0;
  return shape;
}

std::size_t bin(double value, double width, std::size_t n) {
  const double b = std::floor(value / width);
  return b <= 0 ? 0 : std::min(n - 1, static_cast<std::size_t>(b));
}

/// What the geometry about a bad element suggests, from what its vertices are.
std::string cause_of(const ModelMesh& mesh, std::size_t t) {
  std::size_t n_fixed = 0, n_steiner = 0;
  for (VertexIndex v : mesh.tetrahedra[t]) {
    n_fixed += mesh.point_kind[v] <= 1;
    n_steiner += mesh.point_kind[v] >= 2;
  }
  if (n_fixed == 4) return "all vertices are given by the input or lie where surfaces intersect";
  return std::to_string(n_steiner) + " of its vertices were added by the mesher";
}

}  // namespace

QualityStatistics measure_quality(const ModelMesh& mesh) {
  QualityStatistics q;
  q.min_dihedral_histogram.assign(18, 0);
  q.dihedral_histogram.assign(18, 0);
  q.radius_ratio_histogram.assign(20, 0);
  if (mesh.tetrahedra.empty()) return q;
  q.min_dihedral = 180;
  q.min_radius_ratio = 1;
  const auto worse = [](const QualityStatistics::Worst& a, const QualityStatistics::Worst& b) {
    return a.min_dihedral != b.min_dihedral ? a.min_dihedral < b.min_dihedral : a.tetrahedron < b.tetrahedron;
  };
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const Tetrahedron& v = mesh.tetrahedra[t];
    const std::array<Vec3, 4> p{mesh.points[v[0]], mesh.points[v[1]], mesh.points[v[2]], mesh.points[v[3]]};
    const Shape shape = shape_of(p);
    ++q.min_dihedral_histogram[bin(shape.min_dihedral, 10, 18)];
    for (double angle : shape.dihedral) ++q.dihedral_histogram[bin(angle, 10, 18)];
    ++q.radius_ratio_histogram[bin(shape.radius_ratio, 0.05, 20)];
    q.min_dihedral = std::min(q.min_dihedral, shape.min_dihedral);
    q.max_dihedral = std::max(q.max_dihedral, shape.max_dihedral);
    q.min_radius_ratio = std::min(q.min_radius_ratio, shape.radius_ratio);
    if (q.worst.size() == n_worst && shape.min_dihedral >= q.worst.back().min_dihedral) continue;
    const Vec3 middle = 0.25 * ((p[0] + p[1]) + (p[2] + p[3]));
    const QualityStatistics::Worst entry{t, shape.min_dihedral, shape.max_dihedral, shape.radius_ratio, middle, mesh.tet_region[t],
                                         cause_of(mesh, t)};
    q.worst.insert(std::upper_bound(q.worst.begin(), q.worst.end(), entry, worse), entry);
    if (q.worst.size() > n_worst) q.worst.pop_back();
  }
  return q;
}

}  // namespace geomesh::geomodel
