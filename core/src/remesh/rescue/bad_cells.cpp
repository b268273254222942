// SPDX-License-Identifier: MIT
#include "remesh/rescue/bad_cells.hpp"

#include <algorithm>

namespace geomesh::remesh {

BadCell bad_cell(const DomainMesh& mesh, CellIndex c) { return {mesh.shape_of(c), c, mesh.vertices(c)}; }

std::vector<BadCell> cells_below(const DomainMesh& mesh, double limit) {
  std::vector<BadCell> bad;
  for (const CellIndex c : mesh.live_cells())
    if (mesh.shape_of(c) < limit) bad.push_back(bad_cell(mesh, c));
  std::sort(bad.begin(), bad.end(), [](const BadCell& a, const BadCell& b) {
    return a.shape != b.shape ? a.shape < b.shape : a.cell < b.cell;
  });
  return bad;
}

bool is_left(const DomainMesh& mesh, const BadCell& b) {
  return mesh.is_live(b.cell) && mesh.vertices(b.cell) == b.vertices;
}

}  // namespace geomesh::remesh
