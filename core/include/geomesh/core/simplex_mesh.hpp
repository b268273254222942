// SPDX-License-Identifier: MIT
/// @file
/// The simplicial complex that every stage of the engine works on: a structure of arrays with ghost cells, in 2 or 3 dimensions.
///
/// Orientation, drawn once. A cell's vertices v0..vD are positively oriented (orient3d > 0, orient2d > 0). Face i is opposite
/// vertex i. In 3D face i lists its vertices in the order `face_vertices[i]`, counter-clockwise seen from vertex i, so that
/// (f0, f1, f2, vi) is positive:
///
///            v3                 face 0: 1 3 2
///           /|\                 face 1: 0 2 3
///          / | \                face 2: 0 3 1
///        v0--|--v2              face 3: 0 1 2
///          \ | /
///           \|/
///            v1
///
/// Ghost cells: each hull face carries one cell whose vertex is `infinite_vertex` (in any position); its orientation is that which it
/// would have with a point outside the hull beyond that face in that position. So every cell has D+1 neighbours and the complex
/// is a topological sphere.
///
/// A neighbour is a `FaceRef`: 4 * cell + index of the shared face in that cell (in 2D too), so that the mirror face is at hand.
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

namespace geomesh {

inline constexpr VertexIndex infinite_vertex = 0xFFFFFFFEu;

using CellIndex = std::uint32_t;
inline constexpr CellIndex no_cell = 0x3FFFFFFFu;  ///< so that 4 * cell + face always fits 32 bits

/// A face seen from one of its two cells.
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

/// face_vertices[i]: local indices of face i, counter-clockwise seen from vertex i (3D).
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> face_vertices{{{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};
/// The six edges of a tetrahedron as pairs of local vertices.
inline constexpr std::array<std::array<std::uint8_t, 2>, 6> edge_vertices{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// D+1 vertices and D+1 neighbours a cell, recycled slots, one byte of flags. No coordinates: those live with the caller.
template <int Dim>
class SimplexMesh {
  static_assert(Dim == 2 || Dim == 3);

 public:
  static constexpr int dimension = Dim;
  static constexpr int n_cell_vertices = Dim + 1;
  using CellVertices = std::array<VertexIndex, Dim + 1>;
  using CellNeighbors = std::array<FaceRef, Dim + 1>;

  /// Slots, live and free. Iterate cells as `for (c = 0; c < n_slots(); ++c) if (is_live(c))`.
  CellIndex n_slots() const { return static_cast<CellIndex>(vertices_.size()); }
  CellIndex n_live() const { return n_slots() - static_cast<CellIndex>(free_.size()); }
  bool is_live(CellIndex c) const { return vertices_[c][0] != no_vertex; }
  bool is_ghost(CellIndex c) const { return ghost_index(c) >= 0; }
  /// Position of the infinite vertex in c, or -1.
  int ghost_index(CellIndex c) const {
    for (int i = 0; i <= Dim; ++i)
      if (vertices_[c][i] == infinite_vertex) return i;
    return -1;
  }

  VertexIndex vertex(CellIndex c, unsigned i) const { return vertices_[c][i]; }
  const CellVertices& vertices(CellIndex c) const { return vertices_[c]; }
  FaceRef mirror(FaceRef f) const { return neighbors_[f.cell()][f.face()]; }
  FaceRef neighbor(CellIndex c, unsigned i) const { return neighbors_[c][i]; }
  CellIndex neighbor_cell(CellIndex c, unsigned i) const { return neighbors_[c][i].cell(); }
  /// Local index of vertex v in c; c must have it.
  unsigned index_of(CellIndex c, VertexIndex v) const {
    for (unsigned i = 0; i <= static_cast<unsigned>(Dim); ++i)
      if (vertices_[c][i] == v) return i;
    return 4u;
  }
  bool has_vertex(CellIndex c, VertexIndex v) const { return index_of(c, v) <= static_cast<unsigned>(Dim); }

  std::uint8_t flags(CellIndex c) const { return flags_[c]; }
  std::uint8_t& flags(CellIndex c) { return flags_[c]; }

  /// A slot from the free list, else a new one; flags zero, neighbours invalid.
  CellIndex add_cell(const CellVertices& v) {
    CellIndex c;
    if (!free_.empty()) {
      c = free_.back();
      free_.pop_back();
      vertices_[c] = v;
      neighbors_[c] = CellNeighbors{};
      flags_[c] = 0;
    } else {
      c = static_cast<CellIndex>(vertices_.size());
      GEOMESH_CHECK(c < no_cell);
      vertices_.push_back(v);
      neighbors_.emplace_back();
      flags_.push_back(0);
    }
    return c;
  }
  void free_cell(CellIndex c) {
    vertices_[c][0] = no_vertex;
    free_.push_back(c);
  }
  void set_vertices(CellIndex c, const CellVertices& v) { vertices_[c] = v; }
  void set_vertex(CellIndex c, unsigned i, VertexIndex v) { vertices_[c][i] = v; }
  /// Links two faces with each other.
  void link(FaceRef a, FaceRef b) {
    neighbors_[a.cell()][a.face()] = b;
    neighbors_[b.cell()][b.face()] = a;
  }
  void reserve(std::size_t n) {
    vertices_.reserve(n);
    neighbors_.reserve(n);
    flags_.reserve(n);
  }
  void clear() {
    vertices_.clear();
    neighbors_.clear();
    flags_.clear();
    free_.clear();
  }

 private:
  std::vector<CellVertices> vertices_;
  std::vector<CellNeighbors> neighbors_;
  std::vector<std::uint8_t> flags_;
  std::vector<CellIndex> free_;
};

using TetMesh = SimplexMesh<3>;
using TriMesh = SimplexMesh<2>;

}  // namespace geomesh
