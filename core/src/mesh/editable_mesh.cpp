// SPDX-License-Identifier: MIT
#include "mesh/editable_mesh.hpp"

namespace geomesh {

namespace {

/// Walks around the edge (a, b) from cell `start` until the ring of cells closes or ends outside of the mesh. Each step
/// enters a cell, positive in the order (a, b, x, y), and leaves it across the face opposite x.
bool turn_forward(const TetMesh& mesh, CellIndex start, VertexIndex a, VertexIndex b, std::vector<CellIndex>& cells,
                  std::vector<VertexIndex>& ring) {
  cells.clear();
  ring.clear();
  for (CellIndex c = start;;) {
    const auto& [x, y] = even_completion[mesh.index_of(c, a)][mesh.index_of(c, b)];
    cells.push_back(c);
    ring.push_back(mesh.vertex(c, x));
    const FaceRef next = mesh.neighbor(c, x);
    if (!next.valid()) {
      ring.push_back(mesh.vertex(c, y));
      return false;
    }
    c = next.cell();
    if (c == start) return true;
  }
}

}  // namespace

bool turn_about_edge(const TetMesh& mesh, CellIndex start, VertexIndex a, VertexIndex b, std::vector<CellIndex>& cells,
                     std::vector<VertexIndex>& ring) {
  if (turn_forward(mesh, start, a, b, cells, ring)) return true;
  CellIndex first = start;
  for (;;) {
    const FaceRef back = mesh.neighbor(first, even_completion[mesh.index_of(first, a)][mesh.index_of(first, b)][1]);
    if (!back.valid()) break;
    first = back.cell();
  }
  return first == start ? false : turn_forward(mesh, first, a, b, cells, ring);
}

}  // namespace geomesh
