// SPDX-License-Identifier: MIT
#include "recover/model/crossing.hpp"

#include "recover/model/recovery_budget.hpp"

namespace geomesh::recover {

namespace {

/// Whether b is in the closed cone of cell c about its vertex a; if so, what the ray crosses.
bool crossing_in_cell(const ConstrainedMesh& mesh, CellIndex c, VertexIndex a, VertexIndex b, Crossing& out) {
  const TetMesh& cells = mesh.cells();
  const unsigned i = cells.index_of(c, a);
  const auto& v = cells.vertices(c);
  const auto& local = face_vertices[i];
  std::array<Sign, 3> side;  // of the plane opposite local[k]
  for (unsigned k = 0; k < 3; ++k) {
    side[k] = mesh.orient(a, v[local[(k + 1) % 3]], v[local[(k + 2) % 3]], b);
    if (side[k] == Sign::positive) return false;
  }
  out.cell = c;
  out.face = FaceRef(c, i);
  unsigned n = 0;
  for (unsigned k = 0; k < 3; ++k)
    if (side[k] == Sign::negative) out.v[n++] = v[local[k]];
  out.kind = n == 1 ? CrossingKind::vertex : n == 2 ? CrossingKind::edge : CrossingKind::face;
  return n > 0;
}

}  // namespace

Crossing first_crossing(ConstrainedMesh& mesh, VertexIndex a, VertexIndex b) {
  Crossing out;
  const TetMesh& cells = mesh.cells();
  CellIndex c = mesh.cell_of(a);
  Random random = walk_choices(a, b);
  for (unsigned step = 0; step < recovery_budget.star_walk && !cells.is_ghost(c); ++step) {
    if (cells.has_vertex(c, b)) {
      out.cell = c;
      return out;
    }
    if (crossing_in_cell(mesh, c, a, b, out)) return out;
    const unsigned exit = mesh.exit_towards(c, a, b, random);
    if (exit == 4) break;
    c = cells.neighbor_cell(c, exit);
  }
  std::vector<CellIndex> star;
  mesh.star(a, star);
  for (CellIndex s : star)
    if (cells.has_vertex(s, b)) {
      out.cell = s;
      return out;
    }
  for (CellIndex s : star)
    if (!cells.is_ghost(s) && crossing_in_cell(mesh, s, a, b, out)) return out;
  GEOMESH_CHECK(!"the star of a vertex covers all directions");
  return out;
}

}  // namespace geomesh::recover
