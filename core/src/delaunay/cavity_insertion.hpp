// SPDX-License-Identifier: MIT
/// @file
/// The cavity algorithm (Bowyer 1981; Watson 1981; Cavalcanti and Mello 1999, section 2.1) in 2 and 3 dimensions. Each
/// insertion locates the point, finds the cells in conflict with it, and connects their border with the point.
#pragma once

#include <limits>
#include <unordered_map>
#include <vector>

#include "delaunay/incremental.hpp"

namespace geomesh {

/// Incremental Delaunay insertion by cavities. The conflict test is exact and perturbed, so that the cavity is
/// star-shaped with respect to the new point (Cavalcanti and Mello 1999, equation 1). Builds with expensive checks
/// verify this with the orientation predicate for every face.
template <class Space, bool Shared = false>
class CavityInsertion : public IncrementalTriangulation<Space, Shared> {
  using Base = IncrementalTriangulation<Space, Shared>;
  using Base::cavity_flag, Base::cells_, Base::dimension, Base::flags_, Base::ghost_flag, Base::infinite_,
      Base::n_faces, Base::space_;
  using typename Base::Cell, typename Base::CellVertices;

 public:
  using Base::Base;

  /// Inserts vertex v. A point closer than `cluster_distance` to a vertex is not inserted (3D only).
  InsertionOutcome insert(VertexIndex v, double cluster_distance = 0);

 private:
  using Face = CavityFace<dimension>;

  bool conflicts(CellIndex n, const Vec3& p) {
    const CellVertices& w = cells_[n].vertices;
    return flags_[n] & ghost_flag ? space_.ghost_conflict(w, p) : space_.finite_conflict(w, p);
  }
  bool find_cavity(CellIndex first, const Vec3& p);
  bool grow_cavity(const Vec3& p);
  bool grow_cavity_by_lanes(const Vec3& p);
  void enlarge_lists();
  void close_cavity();
  bool star_shaped(const Vec3& p);
  void stellate(VertexIndex v);
  unsigned number_boundary();
  void link_by_table(VertexIndex v);
  void link_by_map(VertexIndex v);
  void write_cell(std::size_t k, VertexIndex v);
  std::uint16_t& local(VertexIndex v) { return v == infinite_ ? infinite_local_ : space_.record(v).local; }

  static constexpr unsigned table_bits = 6, table_side = 1u << table_bits;

  /// Cells of the cavity, later the slots of the new cells, by boundary face. Only the first n_cavity_ items are valid.
  std::vector<CellIndex> cavity_ = std::vector<CellIndex>(256);
  /// Faces of the cavity. The list is as long as cavity_, but only the first n_boundary_ items are valid.
  std::vector<Face> boundary_ = std::vector<Face>(256);
  std::size_t n_cavity_ = 0, n_boundary_ = 0;
  /// Squared distance of the new point from the nearest vertex, to which it will be connected. Computed only in 3D.
  double nearest_ = std::numeric_limits<double>::infinity();
  std::array<VertexIndex, table_side + 1> numbered_;  ///< vertices of the cavity's boundary by their local numbers
  std::array<std::array<std::uint16_t, 4>, 2 * table_side> number_;  ///< by boundary face: local numbers of vertices
  std::uint16_t infinite_local_ = PointRecord::no_local;
  /// Faces of new cells that wait for their neighbour. 3D: row a, column b has the face on the directed boundary edge
  /// (a, b). 2D: row 0 has the face on boundary vertex b of the new cell whose edge begins with b, row 1 the other.
  std::array<FaceRef, table_side * table_side> table_;
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
    this->hint_ = c;
    return InsertionOutcome::not_owned;
  }
  if (nearest_ < cluster_distance * cluster_distance) {
    close_cavity();
    this->hint_ = c;
    return InsertionOutcome::too_near;
  }
  GEOMESH_EXPENSIVE_CHECK(star_shaped(p));
  if (n_boundary_ > n_cavity_ && !this->make_room(n_boundary_ - n_cavity_)) {
    close_cavity();
    return InsertionOutcome::not_owned;
  }
  stellate(v);
  return InsertionOutcome::inserted;
}

template <class Space, bool Shared>
bool CavityInsertion<Space, Shared>::find_cavity(CellIndex first, const Vec3& p) {
  flags_[first] |= cavity_flag;
  cavity_[0] = first;
  n_cavity_ = 1;
  n_boundary_ = 0;
  if constexpr (dimension == 3)
    return grow_cavity_by_lanes(p);
  else
    return grow_cavity(p);
}

template <class Space, bool Shared>
bool CavityInsertion<Space, Shared>::grow_cavity(const Vec3& p) {
  for (std::size_t k = 0; k < n_cavity_; ++k) {
    if (std::max(n_cavity_, n_boundary_) + n_faces > cavity_.size()) enlarge_lists();
    const Cell& cell = cells_[cavity_[k]];
    for (unsigned i = 0; i < n_faces; ++i) {
      const FaceRef outer = cell.neighbors[i];
      const CellIndex n = outer.cell();
      if (flags_[n] & cavity_flag) continue;
      if (conflicts(n, p)) {
        if (!this->owns_cell(cells_[n].vertices)) return false;
        flags_[n] |= cavity_flag;
        cavity_[n_cavity_++] = n;
      } else {
        const auto f = face_of<dimension>(i);
        Face& b = boundary_[n_boundary_++];
        for (unsigned j = 0; j < dimension; ++j) b.vertices[j] = cell.vertices[f[j]];
        b.outer = outer;
      }
    }
  }
  return true;
}

template <class Space, bool Shared>
void CavityInsertion<Space, Shared>::enlarge_lists() {
  cavity_.resize(2 * cavity_.size());
  boundary_.resize(cavity_.size());
}

template <class Space, bool Shared>
bool CavityInsertion<Space, Shared>::grow_cavity_by_lanes(const Vec3& p) {
  struct Host final : CavityHost {
    CavityInsertion& insertion;
    const Vec3& p;
    Host(CavityInsertion& i, const Vec3& q) : insertion(i), p(q) {}
    unsigned decide(const Cell& cell, unsigned undecided, const double* value) override {
      unsigned conflict = 0;
      for (unsigned i = 0; i < n_faces; ++i) {
        if (!(undecided >> i & 1u)) continue;
        const CellIndex n = cell.neighbors[i].cell();
        const bool ghost = insertion.flags_[n] & ghost_flag;
        const CellVertices& v = insertion.cells_[n].vertices;
        conflict |= (ghost                                              ? insertion.space_.ghost_conflict(v, p)
                     : insertion.space_.finite_conflict(v, p, value[i]) ? 1u
                                                                        : 0u)
                    << i;
      }
      return conflict;
    }
    void lend(CavityLists& lists) {
      lists.cells = insertion.cavity_.data();
      lists.faces = insertion.boundary_.data();
      lists.capacity = insertion.cavity_.size();
    }
    void enlarge(CavityLists& lists) override {
      insertion.enlarge_lists();
      lend(lists);
    }
  } host(*this, p);
  CavityLists lists;
  lists.n_cells = 1;
  host.lend(lists);
  const LaneQuery query{cells_, &space_.record(0), p, space_.exact_reach(), this->owned_};
  const bool owned = lane_kernels().grow(query, flags_, cavity_flag, lists, host);
  n_cavity_ = lists.n_cells;
  n_boundary_ = lists.n_faces;
  nearest_ = lists.nearest;
  return owned;
}

template <class Space, bool Shared>
void CavityInsertion<Space, Shared>::close_cavity() {
  for (std::size_t k = 0; k < n_cavity_; ++k) flags_[cavity_[k]] &= static_cast<std::uint8_t>(~cavity_flag);
}

template <class Space, bool Shared>
bool CavityInsertion<Space, Shared>::star_shaped(const Vec3& p) {
  for (std::size_t k = 0; k < n_boundary_; ++k) {
    const Face& b = boundary_[k];
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
void CavityInsertion<Space, Shared>::stellate(VertexIndex v) {
  for (std::size_t k = n_cavity_; k < n_boundary_; ++k) cavity_[k] = this->slots_.take();
  for (std::size_t k = n_boundary_; k < n_cavity_; ++k) {
    cells_[cavity_[k]].vertices[0] = no_vertex;
    flags_[cavity_[k]] = 0;
    this->slots_.give_back(cavity_[k]);
  }
  // By Euler's formula, a sphere of F triangles has F / 2 + 2 vertices; a circle of F edges has F.
  const std::size_t n_vertices = dimension == 3 ? n_boundary_ / 2 + 2 : n_boundary_;
  if (n_vertices <= table_side)
    link_by_table(v);
  else
    link_by_map(v);
  this->hint_ = cavity_[n_boundary_ - 1];
}

/// Makes new cell k from boundary face k and vertex v. Its neighbours across the faces with v are not linked yet.
template <class Space, bool Shared>
inline void CavityInsertion<Space, Shared>::write_cell(std::size_t k, VertexIndex v) {
  const Face& b = boundary_[k];
  const CellIndex c = cavity_[k];
  Cell& cell = cells_[c];
  bool ghost = false;
  for (unsigned j = 0; j < dimension; ++j) {
    cell.vertices[j] = b.vertices[j];
    ghost |= b.vertices[j] == infinite_;
  }
  cell.vertices[dimension] = v;
  cell.neighbors[dimension] = b.outer;
  cells_[b.outer.cell()].neighbors[b.outer.face()] = FaceRef(c, dimension);
  flags_[c] = ghost ? ghost_flag : 0;
}

/// Numbers the vertices of the cavity's boundary from 0 in their order of occurrence and returns their number. The code
/// has no branch on whether a vertex is new, because that is unpredictable.
template <class Space, bool Shared>
unsigned CavityInsertion<Space, Shared>::number_boundary() {
  const Face* faces = boundary_.data();
  const VertexIndex infinite = infinite_;
  const std::size_t n = n_boundary_;
  unsigned count = 0;
  for (std::size_t k = 0; k < n; ++k)
    for (unsigned j = 0; j < dimension; ++j) {
      const VertexIndex u = faces[k].vertices[j];
      std::uint16_t* at = u == infinite ? &infinite_local_ : &space_.record(u).local;
      const unsigned old = *at;
      const bool fresh = old == PointRecord::no_local;
      const unsigned number = fresh ? count : old;
      *at = static_cast<std::uint16_t>(number);
      numbered_[count] = u;
      count += fresh;
      number_[k][j] = static_cast<std::uint16_t>(number);
    }
  for (unsigned i = 0; i < count; ++i) {
    const VertexIndex u = numbered_[i];
    (u == infinite ? infinite_local_ : space_.record(u).local) = PointRecord::no_local;
  }
  return count;
}

/// Links the new cells in the common case of a small cavity: their faces are stored in a square table by directed edge.
/// Each entry is written before it is read, so the table is never cleared.
template <class Space, bool Shared>
void CavityInsertion<Space, Shared>::link_by_table(VertexIndex v) {
  const unsigned shift = number_boundary() <= 32 ? 5 : table_bits;
  const CellIndex* slots = cavity_.data();
  FaceRef* table = table_.data();
  const std::size_t n_new = n_boundary_;
  const auto at = [table, shift](unsigned a, unsigned b) -> FaceRef& { return table[a << shift | b]; };
  for (std::size_t k = 0; k < n_new; ++k) {
    const CellIndex c = slots[k];
    const auto n = number_[k];
    if constexpr (dimension == 3) {
      at(n[0], n[1]) = FaceRef(c, 2);
      at(n[1], n[2]) = FaceRef(c, 0);
      at(n[2], n[0]) = FaceRef(c, 1);
    } else {
      at(0, n[0]) = FaceRef(c, 1);
      at(1, n[1]) = FaceRef(c, 0);
    }
  }
  const Face* faces = boundary_.data();
  Cell* cells = cells_;
  std::uint8_t* flags = flags_;
  const VertexIndex infinite = infinite_;
  for (std::size_t k = 0; k < n_new; ++k) {
    const CellIndex c = slots[k];
    const auto n = number_[k];
    const Face& face = faces[k];
    Cell& cell = cells[c];
    if constexpr (dimension == 3) {
      const FaceRef a = at(n[2], n[1]), b = at(n[0], n[2]), d = at(n[1], n[0]);
      cell.vertices = {face.vertices[0], face.vertices[1], face.vertices[2], v};
      cell.neighbors = {a, b, d, face.outer};
    } else {
      const FaceRef a = at(0, n[1]), b = at(1, n[0]);
      cell.vertices = {face.vertices[0], face.vertices[1], v};
      cell.neighbors = {a, b, face.outer};
    }
    cells[face.outer.cell()].neighbors[face.outer.face()] = FaceRef(c, dimension);
    bool ghost = false;
    for (const VertexIndex u : face.vertices) ghost |= u == infinite;
    flags[c] = ghost ? ghost_flag : 0;
  }
}

/// Links the new cells of a large cavity, with a map of their faces by the boundary edge (3D) or vertex (2D) on them.
template <class Space, bool Shared>
void CavityInsertion<Space, Shared>::link_by_map(VertexIndex v) {
  std::unordered_map<std::uint64_t, FaceRef> open;
  open.reserve(n_boundary_ * dimension);
  const auto key = [](VertexIndex a, VertexIndex b) { return std::uint64_t{a} << 32 | b; };
  for (std::size_t k = 0; k < n_boundary_; ++k) {
    write_cell(k, v);
    const auto& u = boundary_[k].vertices;
    for (unsigned j = 0; j < dimension; ++j) {
      // Face j of a new cell contains the edge opposite vertex j of its boundary face; in 2D, that face's other vertex.
      const VertexIndex a = u[(j + 1) % dimension], b = dimension == 3 ? u[(j + 2) % dimension] : a;
      const FaceRef face(cavity_[k], j);
      const auto [at, is_new] =
          open.try_emplace(dimension == 3 ? key(std::min(a, b), std::max(a, b)) : key(a, a), face);
      if (!is_new) this->mesh_.link(face, at->second);
    }
  }
}

}  // namespace geomesh
