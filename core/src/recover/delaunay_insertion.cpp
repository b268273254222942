// SPDX-License-Identifier: MIT
#include "recover/delaunay_insertion.hpp"

#include <algorithm>
#include <unordered_set>

namespace geomesh::recover {

DelaunayInsertion insert_delaunay(ConstrainedMesh& mesh, const Vec3& p, CellIndex start) {
  const TetMesh& cells = mesh.cells();
  DelaunayInsertion out;
  const CellIndex first = mesh.locate(p, start);
  if (first == no_cell) return out;
  for (VertexIndex v : cells.vertices(first))
    if (mesh.point(v) == p) return out;
  const auto conflicts = [&](CellIndex c) {
    if (cells.is_ghost(c)) return false;  // p lies strictly inside the box
    const auto& v = cells.vertices(c);
    return in_sphere_perturbed(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]), p) == Sign::positive;
  };
  std::vector<CellIndex> cavity{first};
  std::unordered_set<CellIndex> seen{first}, inside{first};
  for (std::size_t i = 0; i < cavity.size(); ++i)
    for (unsigned f = 0; f < 4; ++f) {
      const CellIndex n = cells.neighbor_cell(cavity[i], f);
      if (!seen.insert(n).second || !conflicts(n)) continue;
      cavity.push_back(n);
      inside.insert(n);
    }
  const VertexIndex x = mesh.add_point(p);
  std::vector<Tetrahedron> star;
  for (CellIndex c : cavity) {
    out.removed.push_back(cells.vertices(c));
    for (unsigned f = 0; f < 4; ++f) {
      if (inside.count(cells.neighbor_cell(c, f))) continue;
      const auto& v = cells.vertices(c);
      const auto& l = face_vertices[f];
      star.push_back({v[l[0]], v[l[1]], v[l[2]], x});
      GEOMESH_CHECK(mesh.positive(star.back()));
    }
  }
  mesh.replace(cavity, star);
  out.vertex = x;
  return out;
}

bool is_locally_delaunay(const ConstrainedMesh& mesh) {
  const TetMesh& cells = mesh.cells();
  const auto counts = [&](CellIndex c) {
    const auto& v = cells.vertices(c);
    return std::none_of(v.begin(), v.end(), [&](VertexIndex u) { return u == infinite_vertex || mesh.is_box_vertex(u); });
  };
  for (CellIndex c = 0; c < cells.n_slots(); ++c) {
    if (!cells.is_live(c) || !counts(c)) continue;
    const auto& v = cells.vertices(c);
    for (unsigned f = 0; f < 4; ++f) {
      const FaceRef g = cells.neighbor(c, f);
      if (!counts(g.cell())) continue;
      const VertexIndex d = cells.vertex(g.cell(), g.face());
      if (in_sphere(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]), mesh.point(d)) == Sign::positive) return false;
    }
  }
  return true;
}

}  // namespace geomesh::recover
