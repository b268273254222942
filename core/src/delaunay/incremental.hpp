// SPDX-License-Identifier: MIT
/// @file
/// The common base of the incremental algorithms in 2 and 3 dimensions (Cavalcanti and Mello 1999, end of section 2.1).
/// It makes the first simplex with its ghosts, locates points, and knows which cells a part of a parallel run owns. The
/// algorithms in cavity_insertion.hpp and flip_insertion.hpp are derived from it.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "common/random.hpp"
#include "delaunay/kernels/lane_kernels.hpp"
#include "delaunay/slots.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

enum class InsertionOutcome {
  inserted,
  duplicate,  ///< the point equals a vertex, which `IncrementalTriangulation::twin()` returns
  too_near,   ///< the point is closer to a vertex than cluster_distance; nothing was changed
  not_owned,  ///< nothing changed: the insertion needs cells that another part of the parallel run owns
};

/// Base of the incremental algorithms. Vertices are positions in insertion order; the infinite vertex follows the last.
template <class Space, bool Shared>
class IncrementalTriangulation {
 public:
  static constexpr unsigned dimension = Space::dimension;
  static constexpr unsigned n_faces = dimension + 1;
  using Mesh = SimplexMesh<Space::dimension>;
  using Cell = typename Mesh::Cell;
  using CellVertices = typename Mesh::CellVertices;
  static constexpr std::uint8_t ghost_flag = 1, cavity_flag = 2;

  IncrementalTriangulation(Mesh& mesh, const Space& space, SlotSource slots, Ownership owned = {})
      : mesh_(mesh), space_(space), slots_(std::move(slots)), owned_(owned), infinite_(space.infinite()) {
    refresh();
  }

  /// Makes the first simplex of an empty mesh from affinely independent, positively oriented vertices.
  void start(const CellVertices& first);

  /// Returns the cell that contains p, or the ghost of a hull face that p is beyond. The next walk starts at this cell.
  CellIndex locate(const Vec3& p) { return hint_ = walk(p); }
  void set_hint(CellIndex c) { hint_ = c; }
  CellIndex hint() const { return hint_; }
  VertexIndex twin() const { return twin_; }
  std::size_t walk_steps() const { return walk_steps_; }
  const Space& space() const { return space_; }
  const SlotSource& slots() const { return slots_; }
  SlotSource& slots() { return slots_; }
  /// Updates pointers into the mesh. Must be called when the mesh has grown.
  void refresh() {
    cells_ = mesh_.cells();
    flags_ = mesh_.cell_flags();
  }

 protected:
  /// Returns a cell in conflict with p: the cell that contains p, or the ghost of a hull face beyond which p lies;
  /// no_cell if the walk leaves the cells that this part of a parallel run owns.
  CellIndex walk(const Vec3& p);
  /// Returns the vertex of c equal to p, or no_vertex.
  VertexIndex equal_vertex(const CellVertices& v, const Vec3& p) const;

  bool owns(VertexIndex v) const {
    if constexpr (!Shared) return true;
    if (v == infinite_) return true;
    const std::uint16_t place = space_.record(v).place;
    return owned_.first <= place && place < owned_.end;
  }
  bool owns_cell(const CellVertices& v) const {
    if constexpr (!Shared) return true;
    for (const VertexIndex u : v)
      if (!owns(u)) return false;
    return true;
  }
  /// Ends a walk that has reached a cell c of another part, and lets the next walk start at an owned neighbour of c. If
  /// all walks started at the same cell, walks to points along a line would visit ever more cells. No part changes c,
  /// because c has vertices of both parts.
  CellIndex leave_part(CellIndex c) {
    for (const FaceRef& n : cells_[c].neighbors)
      if (owns_cell(cells_[n.cell()].vertices)) hint_ = n.cell();
    return no_cell;
  }
  bool is_ghost(const CellVertices& v) const {
    bool r = false;
    for (const VertexIndex u : v) r |= u == infinite_;
    return r;
  }
  /// Ensures room for n more cells by growing the mesh. Returns false if the mesh is shared and full.
  bool make_room(std::size_t n) {
    if (slots_.has(n)) return true;
    if constexpr (Shared) return false;
    mesh_.grow_to(mesh_.n_slots() + n / SlotSource::block * SlotSource::block + 16 * SlotSource::block);
    slots_.raise_limit(mesh_.n_slots());
    refresh();
    return true;
  }
  Mesh& mesh_;
  Space space_;
  SlotSource slots_;
  Ownership owned_;
  VertexIndex infinite_;
  Cell* cells_ = nullptr;
  std::uint8_t* flags_ = nullptr;
  CellIndex hint_ = no_cell;
  VertexIndex twin_ = no_vertex;
  Random random_;
  std::size_t walk_steps_ = 0;
};

/// Returns the local vertices of face i in the order that makes (face, vertex i) positive.
template <unsigned Dim>
constexpr std::array<std::uint8_t, Dim> face_of(unsigned i) {
  if constexpr (Dim == 3)
    return face_vertices[i];
  else
    return {static_cast<std::uint8_t>((i + 1) % 3), static_cast<std::uint8_t>((i + 2) % 3)};
}

template <class Space, bool Shared>
void IncrementalTriangulation<Space, Shared>::start(const CellVertices& first) {
  make_room(n_faces + 1);
  const CellIndex inner = slots_.take();
  cells_[inner].vertices = first;
  flags_[inner] = 0;
  std::array<CellIndex, n_faces> ghost;
  for (unsigned i = 0; i < n_faces; ++i) {
    // The ghost beyond face i has this face in the opposite order, so two of its vertices are exchanged.
    CellVertices v = first;
    v[i] = infinite_;
    std::swap(v[face_of<dimension>(i)[0]], v[face_of<dimension>(i)[1]]);
    ghost[i] = slots_.take();
    cells_[ghost[i]].vertices = v;
    flags_[ghost[i]] = ghost_flag;
    mesh_.link({inner, i}, {ghost[i], i});
  }
  for (unsigned i = 0; i < n_faces; ++i)
    for (unsigned j = i + 1; j < n_faces; ++j)
      mesh_.link({ghost[i], mesh_.index_of(ghost[i], first[j])}, {ghost[j], mesh_.index_of(ghost[j], first[i])});
  hint_ = inner;
}

/// Remembering walk (Devillers, Pion and Teillaud 2002): it tests the faces of a cell in random order and never leaves
/// through the face by which it entered.
template <class Space, bool Shared>
CellIndex IncrementalTriangulation<Space, Shared>::walk(const Vec3& p) {
  CellIndex c = hint_;
  unsigned entered = n_faces;
  if constexpr (dimension == 3)
    if (lane_kernels().walk({cells_, &space_.record(0), p, space_.exact_reach(), owned_}, c, walk_steps_)) return c;
  if (flags_[c] & ghost_flag) {
    unsigned g = 0;
    while (cells_[c].vertices[g] != infinite_) ++g;
    const FaceRef inner = cells_[c].neighbors[g];
    if constexpr (Shared)
      if (!owns_cell(cells_[inner.cell()].vertices)) return leave_part(inner.cell());
    c = inner.cell();
  } else if constexpr (Shared) {
    if (!owns_cell(cells_[c].vertices)) return leave_part(c);
  }
  for (;;) {
    ++walk_steps_;
    if (flags_[c] & ghost_flag) return c;
    const Cell& cell = cells_[c];
    unsigned i = random_.byte() % n_faces;
    FaceRef next;
    for (unsigned k = 0; k < n_faces; ++k, i = i + 1 == n_faces ? 0 : i + 1) {
      if (i == entered || space_.side(cell.vertices, i, p) != Sign::negative) continue;
      next = cell.neighbors[i];
      break;
    }
    if (!next.valid()) return c;
    c = next.cell();
    entered = next.face();
    if constexpr (Shared)
      if (!owns_cell(cells_[c].vertices)) return leave_part(c);
  }
}

template <class Space, bool Shared>
VertexIndex IncrementalTriangulation<Space, Shared>::equal_vertex(const CellVertices& v, const Vec3& p) const {
  for (const VertexIndex u : v)
    if (u != infinite_ && static_cast<const Vec3&>(space_.record(u)) == p) return u;
  return no_vertex;
}

}  // namespace geomesh
