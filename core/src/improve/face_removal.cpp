// SPDX-License-Identifier: MIT
#include <algorithm>

#include "improve/improve.hpp"
#include "quality/shape.hpp"

namespace geomesh::remesh {

bool remove_face(Toolbox& tools, CellIndex c, unsigned i) {
  DomainMesh& mesh = tools.mesh;
  if (mesh.tag(c, i).constrained()) return false;
  const FaceRef mirror = mesh.topology().neighbor(c, i);
  const Tetrahedron& t = mesh.vertices(c);
  const VertexIndex top = t[i], bottom = mesh.vertices(mirror.cell())[mirror.face()];
  const Triangle f{t[face_vertices[i][0]], t[face_vertices[i][1]], t[face_vertices[i][2]]};
  const double before = std::min(mesh.shape_of(c), mesh.shape_of(mirror.cell())), needed = before * (1 + 1e-6) + 1e-12;
  const Vec3 &p = mesh.point(top), &q = mesh.point(bottom);
  for (unsigned k = 0; k < 3; ++k) {
    const Vec3 &x = mesh.point(f[k]), &y = mesh.point(f[(k + 1) % 3]);
    if (!(shape(x, y, q, p) > needed) || !is_positive(x, y, q, p)) return false;
  }
  auto& added = tools.work.added;
  added.clear();
  for (unsigned k = 0; k < 3; ++k) added.push_back({{f[k], f[(k + 1) % 3], bottom, top}, mesh.component(c), {}});
  const std::array<CellIndex, 2> removed{c, mirror.cell()};
  mesh.replace(removed, added, tools.work.created);
  ++tools.statistics.face_removals;
  return true;
}

}  // namespace geomesh::remesh
