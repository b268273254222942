// SPDX-License-Identifier: MIT
#include "recover/conforming/delaunay_insertion.hpp"

#include <algorithm>

namespace geomesh::recover {

namespace {

/// Edges of a tetrahedron, by position of vertices, each followed by the two vertices that are not on it.
constexpr std::array<std::array<std::uint8_t, 4>, 6> edges_and_others{
    {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}};

/// Lists the faces inside a cavity, and the edges that are lost when its cells are replaced, with a few that are kept.
void list_lost(const ConstrainedMesh& mesh, std::span<const CellIndex> cavity, DelaunayInsertion& out) {
  out.edges.clear();
  out.faces.clear();
  for (const CellIndex c : cavity) {
    const Tetrahedron& v = mesh.cells().vertices(c);
    std::array<bool, 4> is_inner;
    for (unsigned f = 0; f < 4; ++f) {
      const CellIndex n = mesh.cells().neighbor_cell(c, f);
      is_inner[f] = mesh.is_in_cavity(n);
      if (n < c && is_inner[f])
        out.faces.push_back({v[face_vertices[f][0]], v[face_vertices[f][1]], v[face_vertices[f][2]]});
    }
    // An edge of a cell lies in the two faces opposite the other vertices. If one of these faces is on the boundary of
    // the cavity, the edge is on it, too, and remains in the mesh.
    for (const auto& [i, j, k, l] : edges_and_others)
      if (is_inner[k] && is_inner[l]) out.edges.push_back({v[i], v[j]});
  }
}

/// Marks the cells in conflict with p. Returns false if p is outside the mesh or equals a vertex.
bool mark_conflicts(ConstrainedMesh& mesh, const Vec3& p, CellIndex start, std::vector<CellIndex>& cavity) {
  const TetMesh& cells = mesh.cells();
  const CellIndex first = mesh.locate(p, start);
  if (first == no_cell) return false;
  for (const VertexIndex v : cells.vertices(first))
    if (mesh.point(v) == p) return false;
  const auto conflicts = [&](CellIndex c) {
    if (cells.is_ghost(c)) return false;  // ghosts are not in conflict with points strictly inside the box
    const auto& v = cells.vertices(c);
    return in_sphere_perturbed(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]), p) ==
           Sign::positive;
  };
  mesh.find_cavity(first, conflicts, cavity);
  return true;
}

void replace_marked(ConstrainedMesh& mesh, const Vec3& p, std::span<const CellIndex> cavity, DelaunayInsertion& out) {
  list_lost(mesh, cavity, out);
  out.vertex = mesh.add_point(p);
  mesh.replace_by_star(cavity, out.vertex);
  for (const CellIndex c : mesh.last_created()) GEOMESH_CHECK(mesh.positive(mesh.cells().vertices(c)));
}

}  // namespace

void insert_delaunay(ConstrainedMesh& mesh, const Vec3& p, CellIndex start, DelaunayInsertion& out) {
  std::vector<CellIndex> cavity;
  out.vertex = no_vertex;
  if (mark_conflicts(mesh, p, start, cavity)) replace_marked(mesh, p, cavity, out);
}

std::vector<CellIndex> conflict_cells(ConstrainedMesh& mesh, const Vec3& p, CellIndex start) {
  std::vector<CellIndex> cavity;
  if (mark_conflicts(mesh, p, start, cavity)) mesh.unmark_cavity(cavity);
  return cavity;
}

void insert_into(ConstrainedMesh& mesh, const Vec3& p, std::span<const CellIndex> cavity, DelaunayInsertion& out) {
  mesh.mark_cavity(cavity);
  replace_marked(mesh, p, cavity, out);
}

bool is_locally_delaunay(const ConstrainedMesh& mesh) {
  const TetMesh& cells = mesh.cells();
  const auto counts = [&](CellIndex c) {
    const auto& v = cells.vertices(c);
    return std::none_of(v.begin(), v.end(),
                        [&](VertexIndex u) { return u == infinite_vertex || mesh.is_box_vertex(u); });
  };
  for (CellIndex c = 0; c < cells.n_slots(); ++c) {
    if (!cells.is_live(c) || !counts(c)) continue;
    const auto& v = cells.vertices(c);
    for (unsigned f = 0; f < 4; ++f) {
      const FaceRef g = cells.neighbor(c, f);
      if (g.cell() < c || !counts(g.cell())) continue;  // a face is tested only in its cell with the smaller index
      const VertexIndex d = cells.vertex(g.cell(), g.face());
      if (in_sphere(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]), mesh.point(d)) ==
          Sign::positive)
        return false;
    }
  }
  return true;
}

}  // namespace geomesh::recover
