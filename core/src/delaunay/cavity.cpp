// SPDX-License-Identifier: MIT
#include "delaunay/cavity.hpp"

#include <algorithm>
#include <bit>

#include "geomesh/core/predicates.hpp"

namespace geomesh {

void CavityInserter::start(const Tetrahedron& first) {
  const CellIndex inner = mesh_.add_cell(first);
  std::array<CellIndex, 4> ghost;
  for (unsigned i = 0; i < 4; ++i) {
    // The ghost beyond face i sees that face from the other side: swap two of its vertices.
    Tetrahedron v = first;
    v[i] = infinite_vertex;
    std::swap(v[face_vertices[i][0]], v[face_vertices[i][1]]);
    ghost[i] = mesh_.add_cell(v);
    mesh_.link({inner, i}, {ghost[i], i});
  }
  for (unsigned i = 0; i < 4; ++i)
    for (unsigned j = i + 1; j < 4; ++j) {
      // Ghosts i and j share the face of infinity and the edge that misses i and j.
      mesh_.link({ghost[i], mesh_.index_of(ghost[i], first[j])}, {ghost[j], mesh_.index_of(ghost[j], first[i])});
    }
  hint_ = inner;
}

bool CavityInserter::in_conflict(CellIndex c, VertexIndex v) const {
  const auto& t = mesh_.vertices(c);
  const Vec3& p = points_[v];
  const int g = mesh_.ghost_index(c);
  if (g < 0) return in_sphere_perturbed(points_[t[0]], points_[t[1]], points_[t[2]], points_[t[3]], p) == Sign::positive;
  const auto& f = face_vertices[static_cast<unsigned>(g)];
  const Vec3 &a = points_[t[f[0]]], &b = points_[t[f[1]]], &d = points_[t[f[2]]];
  const Sign side = orient3d(a, b, d, p);
  if (side != Sign::zero) return side == Sign::positive;
  return in_circle_coplanar_perturbed(a, b, d, p) == Sign::positive;
}

void CavityInserter::find_conflict_zone(CellIndex first, VertexIndex v) {
  cavity_.clear();
  boundary_.clear();
  mesh_.flags(first) |= conflict_flag;
  cavity_.push_back(first);
  for (std::size_t next = 0; next < cavity_.size(); ++next) {
    const CellIndex c = cavity_[next];
    for (unsigned i = 0; i < 4; ++i) {
      const CellIndex n = mesh_.neighbor_cell(c, i);
      if (mesh_.flags(n) & conflict_flag) continue;
      if (in_conflict(n, v)) {
        mesh_.flags(n) |= conflict_flag;
        cavity_.push_back(n);
      } else {
        boundary_.push_back({FaceRef(c, i)});
      }
    }
  }
}

void CavityInserter::link_by_edge(VertexIndex a, VertexIndex b, FaceRef f) {
  const std::uint64_t key = static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
  std::size_t slot = (key * 0x9E3779B97F4A7C15ull) >> 32;
  for (;; ++slot) {
    EdgeSlot& s = edges_[slot & (edges_.size() - 1)];
    if (s.epoch != epoch_) {
      s = {key, epoch_, f};
      return;
    }
    if (s.key == key) {
      mesh_.link(f, s.face);
      return;
    }
  }
}

void CavityInserter::stellate(VertexIndex v) {
  if (edges_.size() < 4 * boundary_.size()) edges_.assign(std::bit_ceil(8 * boundary_.size()), EdgeSlot{});
  ++epoch_;
  for (const BoundaryFace& b : boundary_) {
    const unsigned i = b.inside.face();
    Tetrahedron t = mesh_.vertices(b.inside.cell());
    t[i] = v;
    const FaceRef outer = mesh_.mirror(b.inside);
    const CellIndex c = mesh_.add_cell(t);
    mesh_.link({c, i}, outer);
    const auto& f = face_vertices[i];
    for (unsigned k = 0; k < 3; ++k) link_by_edge(t[f[(k + 1) % 3]], t[f[(k + 2) % 3]], {c, f[k]});
    hint_ = c;
  }
  for (const CellIndex c : cavity_) mesh_.free_cell(c);
}

void CavityInserter::insert(VertexIndex v) {
  const Location at = locate(mesh_, points_, points_[v], hint_, random_, &walk_steps_);
  GEOMESH_CHECK(at.kind != LocationKind::at_vertex);
  find_conflict_zone(at.cell, v);
  stellate(v);
}

}  // namespace geomesh
