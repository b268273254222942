// SPDX-License-Identifier: MIT
#include "recover/operations/star_insertion.hpp"

#include <algorithm>

#include "mesh/cavity.hpp"
#include "recover/model/recovery_budget.hpp"

namespace geomesh::recover {

namespace {

bool contains(std::span<const CellIndex> cells, CellIndex c) {
  return std::find(cells.begin(), cells.end(), c) != cells.end();
}

/// Writes the cells that connect x with the boundary faces of the cavity to `out`. Returns false if one of them is not
/// positive; the cavity must then grow into the cell `grow`, or cannot grow if that is no_cell.
bool stellate(const ConstrainedMesh& mesh, const Cavity& cavity, VertexIndex x, std::vector<Tetrahedron>& out,
              CellIndex& grow) {
  const TetMesh& cells = mesh.cells();
  out.clear();
  grow = no_cell;
  for (CellIndex c : cavity.cells())
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef f(c, i);
      const CellIndex n = cells.neighbor_cell(c, i);
      if (cavity.has(n)) {
        if (mesh.is_locked(f)) return false;
        continue;
      }
      const auto& v = cells.vertices(c);
      const auto& l = face_vertices[i];
      const Tetrahedron t{v[l[0]], v[l[1]], v[l[2]], x};
      if (mesh.positive(t)) {
        out.push_back(t);
      } else {
        if (!mesh.is_locked(f) && !cells.is_ghost(n)) grow = n;
        return false;
      }
    }
  return true;
}

/// Returns whether every vertex and subsegment of the cavity (except the subsegment `split`) is on its boundary.
bool keeps_constraints(const ConstrainedMesh& mesh, const Constraints& constraints, std::span<const CellIndex> cavity,
                       std::span<const Tetrahedron> star, Index split) {
  std::vector<std::array<VertexIndex, 2>> kept;
  std::vector<VertexIndex> vertices;
  for (const Tetrahedron& t : star)
    for (unsigned i = 0; i < 3; ++i) {
      kept.push_back({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
      vertices.push_back(t[i]);
    }
  std::sort(kept.begin(), kept.end());
  std::sort(vertices.begin(), vertices.end());
  for (CellIndex c : cavity)
    for (const auto& e : edge_vertices) {
      const VertexIndex a = mesh.cells().vertex(c, e[0]), b = mesh.cells().vertex(c, e[1]);
      if (!std::binary_search(vertices.begin(), vertices.end(), a)) return false;
      if (!std::binary_search(vertices.begin(), vertices.end(), b)) return false;
      const std::array<VertexIndex, 2> key{std::min(a, b), std::max(a, b)};
      if (std::binary_search(kept.begin(), kept.end(), key)) continue;
      const Index s = constraints.subsegment_of(a, b);
      if (s != no_index && s != split) return false;
    }
  return true;
}

}  // namespace

bool insert_in_star(ConstrainedMesh& mesh, const Constraints& constraints, VertexIndex x,
                    std::span<const CellIndex> seeds, Index split) {
  std::vector<CellIndex> cells;
  std::vector<Tetrahedron> star;
  Cavity cavity(mesh.cells(), mesh.marks(), cells, seeds);
  CellIndex grow = no_cell;
  while (!stellate(mesh, cavity, x, star, grow)) {
    if (grow == no_cell || cells.size() >= recovery_budget.star_cells) return false;
    cavity.add(grow);
  }
  if (!keeps_constraints(mesh, constraints, cells, star, split)) return false;
  mesh.replace(cells, star);
  return true;
}

namespace {

/// Returns whether a face of cell c is not visible from x, or is locked and has cells of the cavity on both sides.
bool spoils_star(const ConstrainedMesh& mesh, const Cavity& cavity, CellIndex c, VertexIndex x) {
  const auto& v = mesh.cells().vertices(c);
  for (unsigned f = 0; f < 4; ++f) {
    const auto& l = face_vertices[f];
    const bool is_inner = cavity.has(mesh.cells().neighbor_cell(c, f));
    if (is_inner ? mesh.is_locked(FaceRef(c, f)) : !mesh.positive({v[l[0]], v[l[1]], v[l[2]], x})) return true;
  }
  return false;
}

}  // namespace

bool insert_beside_constraints(ConstrainedMesh& mesh, const Constraints& constraints, VertexIndex x,
                               std::span<const CellIndex> about) {
  const TetMesh& topology = mesh.cells();
  const auto may_cross = [&](FaceRef f) { return !mesh.is_locked(f) && !topology.is_ghost(topology.mirror(f).cell()); };
  const auto conflicts = [&](CellIndex c) {
    const auto& v = topology.vertices(c);
    return in_sphere(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]), mesh.point(x)) ==
           Sign::positive;
  };
  std::vector<CellIndex> cells;
  std::vector<Tetrahedron> star;
  Cavity cavity(topology, mesh.marks(), cells, about);
  cavity.grow(recovery_budget.star_cells, may_cross, conflicts);
  for (std::size_t i = cells.size(); i-- > about.size();)
    if (spoils_star(mesh, cavity, cells[i], x)) {
      cavity.erase(i);
      i = cells.size();  // removing a cell uncovers cavity faces that x may not see: test all cells again
    }
  CellIndex unused = no_cell;
  if (!stellate(mesh, cavity, x, star, unused) || !keeps_constraints(mesh, constraints, cells, star, no_index))
    return insert_in_star(mesh, constraints, x, about);
  mesh.replace(cells, star);
  return true;
}

namespace {

/// Returns the finite cells that contain a point inside or on their boundary, given one of them. side(face) returns on
/// which side of a cell's face the point lies.
template <class Side>
std::vector<CellIndex> cells_touching(const ConstrainedMesh& mesh, CellIndex cell, const Side& side) {
  const TetMesh& cells = mesh.cells();
  std::vector<CellIndex> out{cell};
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto v = cells.vertices(out[i]);
    for (unsigned f = 0; f < 4; ++f) {
      const auto& l = face_vertices[f];
      if (side(Triangle{v[l[0]], v[l[1]], v[l[2]]}) != Sign::zero) continue;
      const CellIndex n = cells.neighbor_cell(out[i], f);
      if (!cells.is_ghost(n) && !contains(out, n)) out.push_back(n);
    }
  }
  return out;
}

}  // namespace

std::vector<CellIndex> cells_about(ConstrainedMesh& mesh, const Vec3& p, CellIndex cell) {
  return cells_touching(
      mesh, cell, [&](const Triangle& t) { return orient3d(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]), p); });
}

std::vector<CellIndex> cells_about_vertex(ConstrainedMesh& mesh, VertexIndex v, CellIndex cell) {
  return cells_touching(mesh, cell, [&](const Triangle& t) { return mesh.orient(t[0], t[1], t[2], v); });
}

CellIndex locate_vertex(ConstrainedMesh& mesh, VertexIndex v, CellIndex start) {
  if (!mesh.has_exact_places()) return mesh.locate(mesh.point(v), start);
  const TetMesh& cells = mesh.cells();
  const auto exit_of = [&](CellIndex c, unsigned first) {
    const Tetrahedron& t = cells.vertices(c);
    for (unsigned k = 0; k < 4; ++k) {
      const unsigned f = (first + k) & 3u;
      const auto& l = face_vertices[f];
      if (mesh.orient(t[l[0]], t[l[1]], t[l[2]], v) == Sign::negative) return f;
    }
    return 4u;
  };
  CellIndex c = start;
  for (std::size_t step = 0; step < 1000 + cells.n_slots(); ++step) {
    if (cells.is_ghost(c)) return no_cell;
    const unsigned exit = exit_of(c, mesh.random(4));
    if (exit == 4) return c;
    c = cells.neighbor_cell(c, exit);
  }
  for (c = 0; c < cells.n_slots(); ++c)
    if (cells.is_live(c) && !cells.is_ghost(c) && exit_of(c, 0) == 4) return c;
  return no_cell;
}

}  // namespace geomesh::recover
