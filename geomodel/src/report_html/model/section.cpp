// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_html/model/section.hpp"

#include <array>

namespace geomesh::geomodel::page {

namespace {

class CuttingPlane {
 public:
  CuttingPlane(const std::vector<Vec3>& points, std::size_t axis, double at)
      : points_(points), axis_(axis), at_(at), u_(axis == 0 ? 1 : 0), v_(axis == 2 ? 1 : 2) {}

  bool above(VertexIndex v) const { return points_[v][axis_] >= at_; }

  /// Returns the point where the plane crosses the edge between two vertices on different sides. The result is the same
  /// for both directions of the edge, so that cuts of neighbouring cells fit together.
  Vec2 crossing(VertexIndex a, VertexIndex b) const {
    if (b < a) std::swap(a, b);
    const Vec3 &p = points_[a], &q = points_[b];
    const double t = (at_ - p[axis_]) / (q[axis_] - p[axis_]);
    return {p[u_] + t * (q[u_] - p[u_]), p[v_] + t * (q[v_] - p[v_])};
  }

 private:
  const std::vector<Vec3>& points_;
  std::size_t axis_;
  double at_;
  std::size_t u_, v_;
};

std::vector<Vec2> cut_tetrahedron(const CuttingPlane& plane, const Tetrahedron& tet) {
  std::array<VertexIndex, 4> above{}, below{};
  std::size_t n_above = 0, n_below = 0;
  for (VertexIndex v : tet) (plane.above(v) ? above[n_above++] : below[n_below++]) = v;
  if (n_above == 0 || n_below == 0) return {};
  if (n_above == 1)
    return {plane.crossing(above[0], below[0]), plane.crossing(above[0], below[1]), plane.crossing(above[0], below[2])};
  if (n_below == 1)
    return {plane.crossing(above[0], below[0]), plane.crossing(above[1], below[0]), plane.crossing(above[2], below[0])};
  return {plane.crossing(above[0], below[0]), plane.crossing(above[0], below[1]), plane.crossing(above[1], below[1]),
          plane.crossing(above[1], below[0])};
}

}  // namespace

Section cut_mesh(const ModelMesh& mesh, std::size_t axis, double at) {
  Section section;
  section.axis = axis;
  section.at = at;
  const CuttingPlane plane(mesh.points, axis, at);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    std::vector<Vec2> polygon = cut_tetrahedron(plane, mesh.tetrahedra[t]);
    if (!polygon.empty()) section.cuts.push_back({mesh.tet_region[t], std::move(polygon)});
  }
  for (const ModelMesh::Face& face : mesh.faces) {
    std::array<Vec2, 2> ends;
    std::size_t n = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexIndex a = face.vertices[i], b = face.vertices[(i + 1) % 3];
      if (plane.above(a) != plane.above(b)) ends[n++] = plane.crossing(a, b);
    }
    if (n == 2) section.traces.push_back({face.surface, ends[0], ends[1]});
  }
  return section;
}

}  // namespace geomesh::geomodel::page
