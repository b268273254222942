// SPDX-License-Identifier: MIT
#include "remesh/sizes/gap_width.hpp"

#include <algorithm>
#include <limits>

#include "quality/measure/shape.hpp"

namespace geomesh::remesh {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Triangle corners(const DomainMesh& mesh, CellIndex c, unsigned i) {
  const Tetrahedron& v = mesh.vertices(c);
  return {v[face_vertices[i][0]], v[face_vertices[i][1]], v[face_vertices[i][2]]};
}

/// Of twice the area; from the cell, it points into it.
Vec3 inward_normal(const DomainMesh& mesh, CellIndex c, unsigned i) {
  const Triangle t = corners(mesh, c, i);
  const Vec3& a = mesh.point(t[0]);
  return cross(mesh.point(t[1]) - a, mesh.point(t[2]) - a);
}

/// Where a ray leaves a cell.
struct Exit {
  unsigned face = 4;
  double at = infinity;
  Vec3 normal;
};

Exit leave(const DomainMesh& mesh, CellIndex c, unsigned entered, const Vec3& origin, const Vec3& direction) {
  Exit first;
  for (unsigned k = 0; k < 4; ++k) {
    if (k == entered) continue;
    const Vec3 m = inward_normal(mesh, c, k);
    const double speed = -dot(m, direction);
    if (!(speed > 0)) continue;
    const double at = dot(m, origin - mesh.point(mesh.vertices(c)[face_vertices[k][0]])) / speed;
    if (at < first.at) first = {k, at, m};
  }
  return first;
}

bool have_common_vertex(const Triangle& s, const Triangle& t) {
  return std::any_of(s.begin(), s.end(), [&](VertexIndex v) { return std::find(t.begin(), t.end(), v) != t.end(); });
}

}  // namespace

double gap_width(const DomainMesh& mesh, CellIndex c, unsigned i, const Vec3& origin) {
  constexpr unsigned most_steps = 500;
  constexpr double least_cosine = 0.5;
  const Vec3 n = inward_normal(mesh, c, i);
  const double l = length(n);
  if (!(l > 0)) return infinity;
  const Vec3 direction = (1 / l) * n;
  const Triangle from = corners(mesh, c, i);
  unsigned entered = i;
  for (unsigned step = 0; step < most_steps; ++step) {
    const Exit out = leave(mesh, c, entered, origin, direction);
    if (out.face == 4) return infinity;
    if (mesh.tag(c, out.face).constrained()) {
      if (have_common_vertex(corners(mesh, c, out.face), from)) return infinity;
      return -dot(out.normal, direction) > least_cosine * length(out.normal) ? std::max(out.at, 0.0) : infinity;
    }
    const FaceRef next = mesh.topology().neighbor(c, out.face);
    c = next.cell();
    entered = next.face();
  }
  return infinity;
}

}  // namespace geomesh::remesh
