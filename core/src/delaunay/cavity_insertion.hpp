// SPDX-License-Identifier: MIT
/// @file
/// The cavity algorithm (Bowyer 1981; Watson 1981; Cavalcanti and Mello 1999, section 2.1) in 2 and 3 dimensions: locate, find
/// the conflict zone, stellate.
#pragma once

#include <cmath>
#include <unordered_map>
#include <vector>

#include "delaunay/face_conflicts.hpp"
#include "delaunay/incremental.hpp"

namespace geomesh {

/// The conflict test is exact and perturbed, so the cavity is star-shaped about the new point (the paper's equation 1); builds
/// with expensive checks assert it by P2 for every face.
template <class Space, bool Shared = false>
class CavityInsertion : public IncrementalTriangulation<Space, Shared> {
  using Base = IncrementalTriangulation<Space, Shared>;
  using Base::cavity_flag, Base::cells_, Base::dimension, Base::flags_, Base::ghost_flag, Base::infinite_, Base::n_faces,
      Base::space_;
  using typename Base::Cell, typename Base::CellVertices;

 public:
  using Base::Base;

  /// Inserts vertex v. Points nearer than `cluster_distance` to a vertex are left out.
  InsertionOutcome insert(VertexIndex v, double cluster_distance = 0);

  std::size_t conflict_tests() const { return conflict_tests_; }
  std::size_t cells_removed() const { return cells_removed_; }
  std::size_t cells_made() const { return cells_made_; }

 private:
  struct BoundaryFace {
    std::array<VertexIndex, dimension> vertices;  ///< in the order that makes (vertices, new point) positive
    FaceRef outer;                                ///< the face as seen from outside the cavity
  };

  bool conflicts(CellIndex n, const Vec3& p, const FaceConflicts* estimate, unsigned i);
  bool find_cavity(CellIndex first, const Vec3& p);
  void close_cavity();
  bool star_shaped(const Vec3& p);
  bool near_boundary(const Vec3& p, double distance) const;
  void number_boundary();
  void stellate(VertexIndex v);
  void link_by_table(VertexIndex v);
  void link_by_map(VertexIndex v);
  void write_cell(std::size_t k, VertexIndex v);
  std::uint16_t& local(VertexIndex v) { return v == infinite_ ? infinite_local_ : space_.record(v).local; }

  static constexpr unsigned table_side = 64;

  std::vector<CellIndex> cavity_;  ///< then the slots of the new cells, by boundary face
  std::vector<BoundaryFace> boundary_;
  std::vector<VertexIndex> numbered_;  ///< vertices of the boundary by local number
  std::uint16_t infinite_local_ = PointRecord::no_local;
  /// 3D: the new cell's face on the directed boundary edge (a, b) at a * table_side + b. 2D: that on boundary vertex a.
  std::array<FaceRef, table_side * table_side> table_;
  std::size_t conflict_tests_ = 0, cells_removed_ = 0, cells_made_ = 0;
};

template <class Space, bool Shared>
InsertionOutcome CavityInsertion<Space, Shared>::insert(VertexIndex v, double cluster_distance) {
  const Vec3& p = space_.record(v);
  const CellIndex c = this->walk(p);
  if (c == no_cell) return InsertionOutcome::not_owned;
  this->twin_ = this->equal_vertex(cells_[c].vertices, p);
  if (this->twin_ != no_vertex) {
    this->hint_ = c;
    return InsertionOutcome::duplicate;
  }
  if (!find_cavity(c, p)) {
    close_cavity();
    return InsertionOutcome::not_owned;
  }
  if (cluster_distance > 0 && near_boundary(p, cluster_distance)) {
    close_cavity();
    this->hint_ = c;
    return InsertionOutcome::too_near;
  }
  GEOMESH_EXPENSIVE_CHECK(star_shaped(p));
  if (boundary_.size() > cavity_.size() && !this->make_room(boundary_.size() - cavity_.size())) {
    close_cavity();
    return InsertionOutcome::not_owned;
  }
  stellate(v);
  return InsertionOutcome::inserted;
}

/// Whether cell n is in conflict with p; `estimate`, where given, knows about the neighbour across face i.
template <class Space, bool Shared>
inline bool CavityInsertion<Space, Shared>::conflicts(CellIndex n, const Vec3& p, [[maybe_unused]] const FaceConflicts* estimate,
                                                      [[maybe_unused]] unsigned i) {
  const CellVertices& w = cells_[n].vertices;
  if (flags_[n] & ghost_flag) return space_.ghost_conflict(w, p);
  if constexpr (dimension == 3)
    if (estimate) return space_.finite_conflict(w, p, estimate->value[i], estimate->error[i]);
  return space_.finite_conflict(w, p);
}

template <class Space, bool Shared>
bool CavityInsertion<Space, Shared>::find_cavity(CellIndex first, const Vec3& p) {
  cavity_.clear();
  boundary_.clear();
  flags_[first] |= cavity_flag;
  cavity_.push_back(first);
  for (std::size_t k = 0; k < cavity_.size(); ++k) {
    const Cell& cell = cells_[cavity_[k]];
    unsigned open = 0;
    CellVertices apex;
    for (unsigned i = 0; i < n_faces; ++i) {
      const FaceRef outer = cell.neighbors[i];
      apex[i] = cells_[outer.cell()].vertices[outer.face()];
      open |= (flags_[outer.cell()] & cavity_flag ? 0u : 1u) << i;
    }
    if (open == 0) continue;
    const bool finite = !(flags_[cavity_[k]] & ghost_flag);
    FaceConflicts estimate;
    if constexpr (dimension == 3)
      if (finite) space_.estimate_neighbors(cell.vertices, apex, p, estimate);
    for (unsigned i = 0; i < n_faces; ++i) {
      const FaceRef outer = cell.neighbors[i];
      const CellIndex n = outer.cell();
      if (!(open >> i & 1u) || (flags_[n] & cavity_flag)) continue;
      ++conflict_tests_;
      if (conflicts(n, p, finite ? &estimate : nullptr, i)) {
        if constexpr (Shared)
          if (!this->owns_cell(cells_[n].vertices)) return false;
        flags_[n] |= cavity_flag;
        cavity_.push_back(n);
        for (const FaceRef next : cells_[n].neighbors) __builtin_prefetch(&cells_[next.cell()]);
      } else {
        const auto f = face_of<dimension>(i);
        BoundaryFace b;
        for (unsigned j = 0; j < dimension; ++j) b.vertices[j] = cell.vertices[f[j]];
        b.outer = outer;
        boundary_.push_back(b);
      }
    }
  }
  return true;
}

template <class Space, bool Shared>
void CavityInsertion<Space, Shared>::close_cavity() {
  for (const CellIndex c : cavity_) flags_[c] &= static_cast<std::uint8_t>(~cavity_flag);
}

template <class Space, bool Shared>
bool CavityInsertion<Space, Shared>::star_shaped(const Vec3& p) {
  for (const BoundaryFace& b : boundary_) {
    CellVertices v{};
    bool finite = true;
    for (unsigned j = 0; j < dimension; ++j) {
      v[j] = b.vertices[j];
      finite = finite && b.vertices[j] != infinite_;
    }
    if (finite && space_.side(v, dimension, p) != Sign::positive) return false;
  }
  return true;
}

template <class Space, bool Shared>
bool CavityInsertion<Space, Shared>::near_boundary(const Vec3& p, double distance) const {
  // The nearest vertex is joined to p in the new triangulation, so it is on the boundary.
  for (const BoundaryFace& b : boundary_)
    for (const VertexIndex u : b.vertices)
      if (u != infinite_ && std::fabs(space_.record(u).x - p.x) < distance && space_.squared_distance(u, p) < distance * distance)
        return true;
  return false;
}

template <class Space, bool Shared>
void CavityInsertion<Space, Shared>::stellate(VertexIndex v) {
  cells_removed_ += cavity_.size();
  cells_made_ += boundary_.size();
  const std::size_t n_old = cavity_.size();
  while (cavity_.size() < boundary_.size()) cavity_.push_back(this->slots_.take());
  for (std::size_t k = boundary_.size(); k < n_old; ++k) {
    cells_[cavity_[k]].vertices[0] = no_vertex;
    flags_[cavity_[k]] = 0;
    this->slots_.give_back(cavity_[k]);
  }
  // Euler: a sphere of F triangles has F / 2 + 2 vertices; a circle of F edges has F.
  const std::size_t n_vertices = dimension == 3 ? boundary_.size() / 2 + 2 : boundary_.size();
  if (n_vertices <= table_side)
    link_by_table(v);
  else
    link_by_map(v);
  this->hint_ = cavity_[boundary_.size() - 1];
}

/// Vertices and outer neighbour of new cell k: (face, v), v being last.
template <class Space, bool Shared>
void CavityInsertion<Space, Shared>::write_cell(std::size_t k, VertexIndex v) {
  const BoundaryFace& b = boundary_[k];
  Cell& cell = cells_[cavity_[k]];
  bool ghost = false;
  for (unsigned j = 0; j < dimension; ++j) {
    cell.vertices[j] = b.vertices[j];
    ghost |= b.vertices[j] == infinite_;
  }
  cell.vertices[dimension] = v;
  cell.neighbors[dimension] = b.outer;
  cells_[b.outer.cell()].neighbors[b.outer.face()] = FaceRef(cavity_[k], dimension);
  flags_[cavity_[k]] = ghost ? ghost_flag : 0;
}

/// The common path: boundary vertices numbered from 0, new faces in a square table by directed edge; each entry is written before
/// it is read, so the table is never cleared.
template <class Space, bool Shared>
void CavityInsertion<Space, Shared>::link_by_table(VertexIndex v) {
  numbered_.clear();
  std::array<std::array<std::uint16_t, 3>, 2 * table_side> number;
  for (std::size_t k = 0; k < boundary_.size(); ++k) {
    for (unsigned j = 0; j < dimension; ++j) {
      const VertexIndex u = boundary_[k].vertices[j];
      std::uint16_t& n = local(u);
      if (n == PointRecord::no_local) {
        n = static_cast<std::uint16_t>(numbered_.size());
        numbered_.push_back(u);
      }
      number[k][j] = n;
    }
    const CellIndex c = cavity_[k];
    const auto& n = number[k];
    if constexpr (dimension == 3) {
      table_[n[0] * table_side + n[1]] = FaceRef(c, 2);
      table_[n[1] * table_side + n[2]] = FaceRef(c, 0);
      table_[n[2] * table_side + n[0]] = FaceRef(c, 1);
    } else {
      table_[n[0]] = FaceRef(c, 1);
      table_[table_side + n[1]] = FaceRef(c, 0);
    }
  }
  for (std::size_t k = 0; k < boundary_.size(); ++k) {
    write_cell(k, v);
    Cell& cell = cells_[cavity_[k]];
    const auto& n = number[k];
    if constexpr (dimension == 3) {
      cell.neighbors[2] = table_[n[1] * table_side + n[0]];
      cell.neighbors[0] = table_[n[2] * table_side + n[1]];
      cell.neighbors[1] = table_[n[0] * table_side + n[2]];
    } else {
      cell.neighbors[1] = table_[table_side + n[0]];
      cell.neighbors[0] = table_[n[1]];
    }
  }
  for (const VertexIndex u : numbered_) local(u) = PointRecord::no_local;
}

/// Large cavities: faces in a map by the rest of the edge or vertex.
template <class Space, bool Shared>
void CavityInsertion<Space, Shared>::link_by_map(VertexIndex v) {
  std::unordered_map<std::uint64_t, FaceRef> open;
  open.reserve(boundary_.size() * dimension);
  const auto key = [](VertexIndex a, VertexIndex b) { return std::uint64_t{a} << 32 | b; };
  for (std::size_t k = 0; k < boundary_.size(); ++k) {
    write_cell(k, v);
    const auto& u = boundary_[k].vertices;
    for (unsigned j = 0; j < dimension; ++j) {
      // 3D: face j is on the edge that leads from vertex j + 1 to j + 2. 2D: face j is on the other vertex.
      const VertexIndex a = u[(j + 1) % dimension], b = dimension == 3 ? u[(j + 2) % dimension] : a;
      const FaceRef face(cavity_[k], j);
      const auto [at, is_new] = open.try_emplace(dimension == 3 ? key(std::min(a, b), std::max(a, b)) : key(a, a), face);
      if (!is_new) this->mesh_.link(face, at->second);
    }
  }
}

}  // namespace geomesh
