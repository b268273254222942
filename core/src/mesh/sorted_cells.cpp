// SPDX-License-Identifier: MIT
#include "mesh/sorted_cells.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace geomesh {

namespace {

/// The even permutations of four vertices. even_orders[i][j] begins with vertex i, followed by the j-th of the three
/// orders of the other vertices that keep the orientation.
constexpr std::uint8_t even_orders[4][3][4] = {{{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}},
                                               {{1, 0, 3, 2}, {1, 3, 2, 0}, {1, 2, 0, 3}},
                                               {{2, 0, 1, 3}, {2, 1, 3, 0}, {2, 3, 0, 1}},
                                               {{3, 0, 2, 1}, {3, 2, 1, 0}, {3, 1, 0, 2}}};

/// An even permutation of a cell's four vertices.
struct Order {
  std::uint8_t first = 0, rotation = 0;
  unsigned operator[](unsigned i) const { return even_orders[first][rotation][i]; }
  unsigned place_of(unsigned old) const {
    unsigned i = 0;
    while ((*this)[i] != old) ++i;
    return i;
  }
};

Order order_of(const Tetrahedron& v) {
  Order out;
  for (std::uint8_t i = 1; i < 4; ++i)
    if (v[i] < v[out.first]) out.first = i;
  const auto second = [&](std::uint8_t j) { return v[even_orders[out.first][j][1]]; };
  for (std::uint8_t j = 1; j < 3; ++j)
    if (second(j) < second(out.rotation)) out.rotation = j;
  return out;
}

}  // namespace

TetMesh with_sorted_cells(const TetMesh& mesh, VertexIndex n_vertices) {
  struct Entry {
    Tetrahedron vertices;
    CellIndex cell;
    /// Sort key of cells that have the same first vertex.
    std::pair<std::uint64_t, VertexIndex> others() const {
      return {std::uint64_t{vertices[1]} << 32 | vertices[2], vertices[3]};
    }
  };
  const CellIndex n = mesh.n_slots();
  std::vector<Order> order(n);
  std::vector<std::size_t> begin(n_vertices + 1, 0);
  for (CellIndex c = 0; c < n; ++c) {
    if (!mesh.is_live(c)) continue;
    order[c] = order_of(mesh.vertices(c));
    ++begin[mesh.vertex(c, order[c].first) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Entry> sorted(begin.back());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (CellIndex c = 0; c < n; ++c) {
    if (!mesh.is_live(c)) continue;
    const Tetrahedron& v = mesh.vertices(c);
    const Order o = order[c];
    sorted[next[v[o[0]]]++] = {{v[o[0]], v[o[1]], v[o[2]], v[o[3]]}, c};
  }
  std::vector<CellIndex> place(n);
  for (VertexIndex v = 0; v < n_vertices; ++v)
    std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(begin[v]),
              sorted.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]),
              [](const Entry& a, const Entry& b) { return a.others() < b.others(); });
  for (CellIndex c = 0; c < sorted.size(); ++c) place[sorted[c].cell] = c;

  TetMesh out;
  out.grow_to(sorted.size());
  for (CellIndex c = 0; c < sorted.size(); ++c) {
    const CellIndex old = sorted[c].cell;
    TetMesh::Cell& cell = out.cells()[c];
    cell.vertices = sorted[c].vertices;
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef beyond = mesh.neighbor(old, order[old][i]);
      cell.neighbors[i] = FaceRef(place[beyond.cell()], order[beyond.cell()].place_of(beyond.face()));
    }
    out.flags(c) = 0;
  }
  return out;
}

}  // namespace geomesh
