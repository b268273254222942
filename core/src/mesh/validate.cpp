// SPDX-License-Identifier: MIT
#include "geomesh/core/validate.hpp"

#include <algorithm>

#include "geomesh/core/predicates.hpp"

namespace geomesh {
namespace {

class FaultList {
 public:
  explicit FaultList(std::size_t limit) : limit_(limit) {}
  void add(const char* what, CellIndex c) {
    if (faults_.size() < limit_) faults_.push_back({what, c});
  }
  std::vector<MeshFault> take() { return std::move(faults_); }

 private:
  std::size_t limit_;
  std::vector<MeshFault> faults_;
};

void check_vertices(const TetMesh& mesh, CellIndex c, FaultList& faults) {
  const auto& v = mesh.vertices(c);
  for (unsigned i = 0; i < 4; ++i)
    for (unsigned j = i + 1; j < 4; ++j)
      if (v[i] == v[j]) faults.add("a cell has a vertex twice", c);
}

/// Returns whether the faces f and g have the same three vertices in opposite cyclic order.
bool seen_from_both_sides(const TetMesh& mesh, FaceRef f, FaceRef g) {
  std::array<VertexIndex, 3> a, b;
  for (unsigned k = 0; k < 3; ++k) {
    a[k] = mesh.vertex(f.cell(), face_vertices[f.face()][k]);
    b[k] = mesh.vertex(g.cell(), face_vertices[g.face()][k]);
  }
  std::swap(b[0], b[1]);
  for (int turn = 0; turn < 3; ++turn) {
    if (a == b) return true;
    std::rotate(b.begin(), b.begin() + 1, b.end());
  }
  return false;
}

void check_neighbors(const TetMesh& mesh, CellIndex c, Outside outside, FaultList& faults) {
  for (unsigned i = 0; i < 4; ++i) {
    const FaceRef f(c, i);
    const FaceRef g = mesh.mirror(f);
    if (!g.valid() && outside == Outside::open) continue;
    if (!g.valid() || g.cell() >= mesh.n_slots() || !mesh.is_live(g.cell())) {
      faults.add("a face has no live neighbour", c);
    } else if (mesh.mirror(g) != f) {
      faults.add("neighbour links are not mutual", c);
    } else if (!seen_from_both_sides(mesh, f, g)) {
      faults.add("two cells disagree on their shared face, or see it from the same side", c);
    }
  }
}

}  // namespace

std::vector<MeshFault> validate_topology(const TetMesh& mesh, std::size_t limit, Outside outside) {
  FaultList faults(limit);
  CellIndex n_live = 0;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c) {
    if (!mesh.is_live(c)) continue;
    ++n_live;
    check_vertices(mesh, c, faults);
    check_neighbors(mesh, c, outside, faults);
  }
  if (n_live != mesh.n_live()) faults.add("the free list does not hold just the free slots", no_cell);
  return faults.take();
}

std::vector<MeshFault> validate_geometry(const TetMesh& mesh, std::span<const Vec3> points, std::size_t limit) {
  FaultList faults(limit);
  for (CellIndex c = 0; c < mesh.n_slots(); ++c) {
    if (!mesh.is_live(c) || mesh.is_ghost(c)) continue;
    const auto& v = mesh.vertices(c);
    if (orient3d(points[v[0]], points[v[1]], points[v[2]], points[v[3]]) != Sign::positive)
      faults.add("a cell is flat or inverted", c);
  }
  return faults.take();
}

std::vector<MeshFault> validate_delaunay(const TetMesh& mesh, std::span<const Vec3> points, std::size_t limit) {
  FaultList faults(limit);
  for (CellIndex c = 0; c < mesh.n_slots(); ++c) {
    if (!mesh.is_live(c)) continue;
    const auto& v = mesh.vertices(c);
    const int g = mesh.ghost_index(c);
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef other = mesh.mirror({c, i});
      const VertexIndex apex = mesh.vertex(other.cell(), other.face());
      if (apex == infinite_vertex) continue;
      const Vec3& p = points[apex];
      if (g < 0) {
        if (in_sphere_perturbed(points[v[0]], points[v[1]], points[v[2]], points[v[3]], p) == Sign::positive)
          faults.add("a face is not locally Delaunay", c);
      } else if (static_cast<unsigned>(g) != i) {
        const auto& f = face_vertices[static_cast<unsigned>(g)];
        const Vec3 &a = points[v[f[0]]], &b = points[v[f[1]]], &d = points[v[f[2]]];
        const Sign side = orient3d(a, b, d, p);
        if (side == Sign::positive) faults.add("the hull is not convex", c);
        if (side == Sign::zero && in_circle_coplanar_perturbed(a, b, d, p) == Sign::positive)
          faults.add("a hull face is not Delaunay in its plane", c);
      }
    }
  }
  return faults.take();
}

}  // namespace geomesh
