// SPDX-License-Identifier: MIT
#include "recover/model/constrained_mesh.hpp"

#include <algorithm>

#include "common/sort_unique.hpp"
#include "recover/model/recovery_budget.hpp"

namespace geomesh::recover {

ConstrainedMesh::ConstrainedMesh(TetMesh mesh, std::vector<Vec3> points, std::size_t n_input)
    : EditableMesh(std::move(mesh), std::move(points)), n_input_(n_input) {
  for (CellIndex c = 0; c < mesh_.n_slots(); ++c) {
    if (!mesh_.is_live(c)) continue;
    mesh_.flags(c) = 0;
    for (VertexIndex v : mesh_.vertices(c))
      if (v != infinite_vertex) cell_of_[v] = c;
  }
}

VertexIndex ConstrainedMesh::add_point(const Vec3& p) {
  points_.push_back(p);
  cell_of_.push_back(no_cell);
  return static_cast<VertexIndex>(points_.size() - 1);
}

VertexIndex ConstrainedMesh::add_point(ExactPlace place) {
  const VertexIndex v = add_point(place.nearest());
  exact_.set(v, std::move(place));
  return v;
}

void ConstrainedMesh::drop_last_point() {
  GEOMESH_CHECK(cell_of_.back() == no_cell);
  exact_.erase(static_cast<VertexIndex>(points_.size() - 1));
  points_.pop_back();
  cell_of_.pop_back();
}

std::vector<VertexIndex> ConstrainedMesh::neighbors(VertexIndex v) {
  std::vector<CellIndex> cells;
  star(v, cells);
  std::vector<VertexIndex> out;
  for (CellIndex c : cells)
    for (VertexIndex w : mesh_.vertices(c))
      if (w != v && w != infinite_vertex) out.push_back(w);
  sort_unique(out);
  return out;
}

unsigned ConstrainedMesh::exit_towards(CellIndex c, VertexIndex a, VertexIndex b, Random& random) const {
  const unsigned i = mesh_.index_of(c, a);
  const auto& v = mesh_.vertices(c);
  unsigned exit = 4, outside = 0;
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned r = face_vertices[i][k], p = face_vertices[i][(k + 1) % 3], q = face_vertices[i][(k + 2) % 3];
    if (orient(a, v[p], v[q], b) != Sign::positive) continue;
    if (++outside == 1 || random.below(outside) == 0) exit = r;
  }
  return exit;
}

CellIndex ConstrainedMesh::find_edge(VertexIndex a, VertexIndex b) {
  // Walks from cell to cell of the star of a towards b. If the walk takes too many steps, all cells of the star are
  // searched.
  CellIndex c = cell_of_[a];
  Random random = walk_choices(a, b);
  for (unsigned step = 0; step < recovery_budget.star_walk; ++step) {
    if (mesh_.has_vertex(c, b)) return c;
    if (mesh_.is_ghost(c)) break;
    const unsigned exit = exit_towards(c, a, b, random);
    if (exit == 4) return no_cell;
    c = mesh_.neighbor_cell(c, exit);
  }
  std::vector<CellIndex> cells;
  star(a, cells);
  for (CellIndex s : cells)
    if (mesh_.has_vertex(s, b)) return s;
  return no_cell;
}

bool ConstrainedMesh::ring(CellIndex cell, VertexIndex a, VertexIndex b, EdgeRing& out) const {
  out.p = a;
  out.q = b;
  turn_about_edge(mesh_, cell, a, b, out.cells, out.ring);
  if (std::find(out.ring.begin(), out.ring.end(), infinite_vertex) != out.ring.end()) return false;
  // Begins the ring at its smallest vertex, so that it does not depend on the course of recovery.
  const auto start = std::min_element(out.ring.begin(), out.ring.end()) - out.ring.begin();
  std::rotate(out.ring.begin(), out.ring.begin() + start, out.ring.end());
  std::rotate(out.cells.begin(), out.cells.begin() + start, out.cells.end());
  return true;
}

FaceRef ConstrainedMesh::face_in_cell(CellIndex cell, VertexIndex a, VertexIndex b, VertexIndex c) const {
  const unsigned i = mesh_.index_of(cell, a), j = mesh_.index_of(cell, b), k = mesh_.index_of(cell, c);
  const unsigned d = 6 - i - j - k;
  const FaceRef f(cell, d);
  // The tetrahedron (a,b,c,d) is positive exactly if its positions in the cell, (i,j,k,d), are an even permutation.
  return even_completion[i][j][0] == k ? f : mesh_.mirror(f);
}

FaceRef ConstrainedMesh::find_face(VertexIndex a, VertexIndex b, VertexIndex c) {
  const CellIndex start = find_edge(a, b);
  return start == no_cell ? FaceRef{} : find_face_about(start, a, b, c);
}

FaceRef ConstrainedMesh::find_face_about(CellIndex start, VertexIndex a, VertexIndex b, VertexIndex c) const {
  CellIndex cell = start;
  VertexIndex pivot = mesh_.vertex(cell, even_completion[mesh_.index_of(cell, a)][mesh_.index_of(cell, b)][0]);
  do {
    if (mesh_.has_vertex(cell, c)) return face_in_cell(cell, a, b, c);
    const unsigned i = mesh_.index_of(cell, a), j = mesh_.index_of(cell, b), p = mesh_.index_of(cell, pivot);
    const VertexIndex next_pivot = mesh_.vertex(cell, 6 - i - j - p);
    cell = mesh_.neighbor_cell(cell, p);
    pivot = next_pivot;
  } while (cell != start);
  return {};
}

CellIndex ConstrainedMesh::locate(const Vec3& p, CellIndex start) {
  const int infinite = mesh_.ghost_index(start);
  const CellIndex first = infinite >= 0 ? mesh_.neighbor_cell(start, static_cast<unsigned>(infinite)) : start;
  const Walk end = walk(
      p, first, 1000 + mesh_.n_slots(), [this] { return random(4); }, [](FaceRef) { return false; });
  if (end.end == Walk::End::found) return end.cell;
  if (end.end == Walk::End::outside) return no_cell;
  for (CellIndex c = 0; c < mesh_.n_slots(); ++c) {
    if (!mesh_.is_live(c) || mesh_.is_ghost(c)) continue;
    const auto& v = mesh_.vertices(c);
    bool inside = true;
    for (const auto& l : face_vertices)
      inside = inside && orient3d(points_[v[l[0]]], points_[v[l[1]]], points_[v[l[2]]], p) != Sign::negative;
    if (inside) return c;
  }
  return no_cell;
}

}  // namespace geomesh::recover
