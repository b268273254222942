// SPDX-License-Identifier: MIT
/// @file
/// The simplicial complex that every stage of the engine works on: cells with ghosts, in 2 or 3 dimensions.
///
/// Orientation, drawn once. A cell's vertices v0..vD are positively oriented (orient3d > 0, orient2d > 0). Face i is
/// opposite vertex i. In 3D face i lists its vertices in the order `face_vertices[i]`, counter-clockwise seen from
/// vertex i, so that (f0, f1, f2, vi) is positive:
///
///            v3                 face 0: 1 3 2
///           /|\                 face 1: 0 2 3
///          / | \                face 2: 0 3 1
///        v0--|--v2              face 3: 0 1 2
///          \ | /
///           \|/
///            v1
///
/// Ghost cells: each hull face has one cell whose vertex is `infinite_vertex` (in any position); its orientation is the
/// one it would have with a point outside the hull beyond that face in that position. Therefore every cell has D+1
/// neighbours and the complex is a topological sphere.
///
/// A neighbour is a `FaceRef`: 4 * cell + index of the shared face in that cell (in 2D too), so that the mirror face is
/// at hand.
///
/// Invariants (validate_topology checks each):
///   1. neighbour links are mutual: mirror(mirror(f)) == f, and both cells list the same vertices on the shared face;
///   2. a live cell has D+1 distinct vertices, at most one of them infinite;
///   3. shared faces are seen with opposite orientation from their two cells;
///   4. freed slots are on the free list and referenced by no live cell.
/// Geometry (validate_geometry): every finite cell has exactly positive orientation.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geomesh/core/error.hpp"
#include "geomesh/core/geometry.hpp"
#include "geomesh/core/pod_array.hpp"

namespace geomesh {

inline constexpr VertexIndex infinite_vertex = 0xFFFFFFFEu;

using CellIndex = std::uint32_t;
inline constexpr CellIndex no_cell = 0x3FFFFFFFu;  ///< chosen so that 4 * cell + face always fits in 32 bits

/// A face as seen from one of its two cells.
struct FaceRef {
  std::uint32_t code = 0xFFFFFFFFu;
  constexpr FaceRef() = default;
  constexpr explicit FaceRef(std::uint32_t c) : code(c) {}
  constexpr FaceRef(CellIndex cell, unsigned face) : code(4 * cell + face) {}
  constexpr CellIndex cell() const { return code >> 2; }
  constexpr unsigned face() const { return code & 3u; }
  constexpr bool valid() const { return code != 0xFFFFFFFFu; }
  friend constexpr bool operator==(FaceRef, FaceRef) = default;
};

/// face_vertices[i]: local indices of face i, counter-clockwise as seen from vertex i (3D).
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> face_vertices{{{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};
/// The six edges of a tetrahedron as pairs of local vertices.
inline constexpr std::array<std::array<std::uint8_t, 2>, 6> edge_vertices{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// The cells of a mesh: D+1 vertices and D+1 neighbours for each, recycled slots, one byte of flags. Coordinates are
/// stored by the caller.
///
/// A cell's vertices and neighbours share one record (32 bytes in 3D, half a cache line), because walks and cavities
/// read both. Flags are in a separate array.
template <int Dim>
class SimplexMesh {
  static_assert(Dim == 2 || Dim == 3);

 public:
  static constexpr int dimension = Dim;
  using CellVertices = std::array<VertexIndex, Dim + 1>;
  using CellNeighbors = std::array<FaceRef, Dim + 1>;
  struct Cell {
    CellVertices vertices;
    CellNeighbors neighbors;
  };

  /// Number of slots, live and free. Iterate over cells with `for (c = 0; c < n_slots(); ++c) if (is_live(c))`.
  CellIndex n_slots() const { return static_cast<CellIndex>(cells_.size()); }
  CellIndex n_live() const { return n_slots() - static_cast<CellIndex>(free_.size()); }
  bool is_live(CellIndex c) const { return cells_[c].vertices[0] != no_vertex; }
  bool is_ghost(CellIndex c) const { return ghost_index(c) >= 0; }
  /// Returns the position of the infinite vertex in c, or -1.
  int ghost_index(CellIndex c) const {
    for (int i = 0; i <= Dim; ++i)
      if (cells_[c].vertices[i] == infinite_vertex) return i;
    return -1;
  }

  VertexIndex vertex(CellIndex c, unsigned i) const { return cells_[c].vertices[i]; }
  const CellVertices& vertices(CellIndex c) const { return cells_[c].vertices; }
  FaceRef mirror(FaceRef f) const { return cells_[f.cell()].neighbors[f.face()]; }
  FaceRef neighbor(CellIndex c, unsigned i) const { return cells_[c].neighbors[i]; }
  CellIndex neighbor_cell(CellIndex c, unsigned i) const { return cells_[c].neighbors[i].cell(); }
  /// Returns the local index of vertex v in c, which must contain it.
  unsigned index_of(CellIndex c, VertexIndex v) const {
    for (unsigned i = 0; i <= static_cast<unsigned>(Dim); ++i)
      if (cells_[c].vertices[i] == v) return i;
    return 4u;
  }
  bool has_vertex(CellIndex c, VertexIndex v) const { return index_of(c, v) <= static_cast<unsigned>(Dim); }

  std::uint8_t flags(CellIndex c) const { return flags_[c]; }
  std::uint8_t& flags(CellIndex c) { return flags_[c]; }

  /// Adds a cell in a slot from the free list, or else in a new slot. Its flags are zero and its neighbours invalid.
  CellIndex add_cell(const CellVertices& v) {
    CellIndex c;
    if (!free_.empty()) {
      c = free_.back();
      free_.pop_back();
    } else {
      c = n_slots();
      GEOMESH_CHECK(c < no_cell);
      cells_.grow_to(std::size_t{c} + 1);
      flags_.grow_to(std::size_t{c} + 1);
    }
    cells_[c] = Cell{v, CellNeighbors{}};
    flags_[c] = 0;
    return c;
  }
  void free_cell(CellIndex c) {
    cells_[c].vertices[0] = no_vertex;
    free_.push_back(c);
  }
  /// Undoes free_cell(c), which must have been the last call of free_cell. The vertices of c are not restored.
  void take_back_freed(CellIndex c) {
    GEOMESH_CHECK(!free_.empty() && free_.back() == c);
    free_.pop_back();
  }
  void set_vertices(CellIndex c, const CellVertices& v) { cells_[c].vertices = v; }
  void set_vertex(CellIndex c, unsigned i, VertexIndex v) { cells_[c].vertices[i] = v; }
  /// Makes the cells of two faces neighbours across these faces.
  void link(FaceRef a, FaceRef b) {
    cells_[a.cell()].neighbors[a.face()] = b;
    cells_[b.cell()].neighbors[b.face()] = a;
  }
  void reserve(std::size_t n) {
    cells_.reserve(n);
    flags_.reserve(n);
  }
  void clear() {
    cells_.clear();
    flags_.clear();
    free_.clear();
  }

  /// @name Access for algorithms that write cells directly into the arrays of the mesh
  /// @{
  Cell* cells() { return cells_.data(); }
  const Cell* cells() const { return cells_.data(); }
  std::uint8_t* cell_flags() { return flags_.data(); }
  std::size_t capacity() const { return cells_.capacity(); }
  /// Increases the number of cell slots to n. The new ones are neither initialised nor on the free list. They must be
  /// filled, or marked with `vertices[0] = no_vertex` and removed by `compact`.
  void grow_to(std::size_t n) {
    GEOMESH_CHECK(n <= no_cell);
    cells_.grow_to(n);
    flags_.grow_to(n);
  }
  /// Removes all cell slots from index n on, which must be neither live nor on the free list.
  void drop_slots_from(std::size_t n) {
    cells_.truncate(n);
    flags_.truncate(n);
  }
  /// Moves the last live cells into slots that are not live, in order, and removes all other slots. None is free then.
  void compact() {
    CellIndex hole = 0, last = n_slots();
    for (;; ++hole) {
      while (last > 0 && !is_live(last - 1)) --last;
      while (hole < last && is_live(hole)) ++hole;
      if (hole >= last) break;
      --last;
      cells_[hole] = cells_[last];
      flags_[hole] = flags_[last];
      for (unsigned i = 0; i <= static_cast<unsigned>(Dim); ++i) {
        const FaceRef n = cells_[hole].neighbors[i];
        cells_[n.cell()].neighbors[n.face()] = FaceRef(hole, i);
      }
    }
    cells_.truncate(last);
    flags_.truncate(last);
    free_.clear();
  }
  /// @}

 private:
  PodArray<Cell> cells_;
  PodArray<std::uint8_t> flags_;
  std::vector<CellIndex> free_;
};

using TetMesh = SimplexMesh<3>;
using TriMesh = SimplexMesh<2>;

}  // namespace geomesh
