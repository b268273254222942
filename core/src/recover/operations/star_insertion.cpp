// SPDX-License-Identifier: MIT
#include "recover/operations/star_insertion.hpp"

#include <algorithm>

namespace geomesh::recover {

namespace {

constexpr std::size_t max_cavity = 400;

bool contains(std::span<const CellIndex> cells, CellIndex c) {
  return std::find(cells.begin(), cells.end(), c) != cells.end();
}

/// Marks cells of a cavity (ConstrainedMesh::is_in_cavity) while it is sought; takes the marks off again.
class MarkedCavity {
 public:
  MarkedCavity(ConstrainedMesh& mesh, std::span<const CellIndex> cells)
      : mesh_(mesh), cells_(cells.begin(), cells.end()) {
    mesh.mark_cavity(cells_, true);
  }
  ~MarkedCavity() { mesh_.mark_cavity(cells_, false); }
  MarkedCavity(const MarkedCavity&) = delete;
  MarkedCavity& operator=(const MarkedCavity&) = delete;

  const std::vector<CellIndex>& cells() const { return cells_; }
  void add(CellIndex c) {
    cells_.push_back(c);
    mesh_.mark_cavity({&c, 1}, true);
  }
  void erase(std::size_t i) {
    mesh_.mark_cavity({&cells_[i], 1}, false);
    cells_.erase(cells_.begin() + static_cast<std::ptrdiff_t>(i));
  }

 private:
  ConstrainedMesh& mesh_;
  std::vector<CellIndex> cells_;
};

/// Of a marked cavity: boundary faces as (f0, f1, f2, x), or false where the cavity has to grow over `*grow` (no_cell:
/// it cannot).
bool stellate(const ConstrainedMesh& mesh, std::span<const CellIndex> cavity, VertexIndex x,
              std::vector<Tetrahedron>& out, CellIndex& grow) {
  const TetMesh& cells = mesh.cells();
  out.clear();
  grow = no_cell;
  for (CellIndex c : cavity)
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef f(c, i);
      const CellIndex n = cells.neighbor_cell(c, i);
      if (mesh.is_in_cavity(n)) {
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

/// Whether every vertex and subsegment of the cavity (but `split`) is on its boundary.
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
  {
    MarkedCavity cavity(mesh, seeds);
    CellIndex grow = no_cell;
    while (!stellate(mesh, cavity.cells(), x, star, grow)) {
      if (grow == no_cell || cavity.cells().size() >= max_cavity) return false;
      cavity.add(grow);
    }
    if (!keeps_constraints(mesh, constraints, cavity.cells(), star, split)) return false;
    cells = cavity.cells();
  }
  mesh.replace(cells, star);
  return true;
}

namespace {

/// Adds the cells in conflict with x that are reached without passing a locked face.
void add_conflicts(const ConstrainedMesh& mesh, VertexIndex x, MarkedCavity& cavity) {
  const TetMesh& cells = mesh.cells();
  for (std::size_t i = 0; i < cavity.cells().size() && cavity.cells().size() < max_cavity; ++i)
    for (unsigned f = 0; f < 4; ++f) {
      const FaceRef face(cavity.cells()[i], f);
      const CellIndex n = cells.mirror(face).cell();
      if (cells.is_ghost(n) || mesh.is_locked(face) || mesh.is_in_cavity(n)) continue;
      const auto& v = cells.vertices(n);
      if (in_sphere(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]), mesh.point(x)) ==
          Sign::positive)
        cavity.add(n);
    }
}

/// Whether a face of the cavity's cell c is hidden from x, or locked with the cavity on both sides.
bool spoils_star(const ConstrainedMesh& mesh, CellIndex c, VertexIndex x) {
  const auto& v = mesh.cells().vertices(c);
  for (unsigned f = 0; f < 4; ++f) {
    const auto& l = face_vertices[f];
    const bool is_inner = mesh.is_in_cavity(mesh.cells().neighbor_cell(c, f));
    if (is_inner ? mesh.is_locked(FaceRef(c, f)) : !mesh.positive({v[l[0]], v[l[1]], v[l[2]], x})) return true;
  }
  return false;
}

}  // namespace

bool insert_beside_constraints(ConstrainedMesh& mesh, const Constraints& constraints, VertexIndex x,
                               std::span<const CellIndex> about) {
  std::vector<CellIndex> cells;
  std::vector<Tetrahedron> star;
  {
    MarkedCavity cavity(mesh, about);
    add_conflicts(mesh, x, cavity);
    for (std::size_t i = cavity.cells().size(); i-- > about.size();)
      if (spoils_star(mesh, cavity.cells()[i], x)) {
        cavity.erase(i);
        i = cavity.cells().size();  // its neighbours may be hidden now
      }
    CellIndex unused = no_cell;
    if (stellate(mesh, cavity.cells(), x, star, unused) &&
        keeps_constraints(mesh, constraints, cavity.cells(), star, no_index))
      cells = cavity.cells();
  }
  if (cells.empty()) return insert_in_star(mesh, constraints, x, about);
  mesh.replace(cells, star);
  return true;
}

std::vector<CellIndex> cells_about(ConstrainedMesh& mesh, const Vec3& p, CellIndex cell) {
  const TetMesh& cells = mesh.cells();
  std::vector<CellIndex> out{cell};
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto v = cells.vertices(out[i]);
    for (unsigned f = 0; f < 4; ++f) {
      const auto& l = face_vertices[f];
      if (orient3d(mesh.point(v[l[0]]), mesh.point(v[l[1]]), mesh.point(v[l[2]]), p) != Sign::zero) continue;
      const CellIndex n = cells.neighbor_cell(out[i], f);
      if (!cells.is_ghost(n) && !contains(out, n)) out.push_back(n);
    }
  }
  return out;
}

}  // namespace geomesh::recover
