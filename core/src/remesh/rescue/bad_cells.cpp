// SPDX-License-Identifier: MIT
#include "remesh/rescue/bad_cells.hpp"

#include <algorithm>

namespace geomesh::remesh {

BadCell bad_cell(const DomainMesh& mesh, CellIndex c) { return {mesh.shape_of(c), c, mesh.vertices(c)}; }

std::size_t count_below(const DomainMesh& mesh, double limit) {
  std::size_t n = 0;
  for (const CellIndex c : mesh.live_cells()) n += mesh.shape_of(c) < limit;
  return n;
}

std::vector<BadCell> cells_below(const DomainMesh& mesh, double limit) {
  std::vector<BadCell> bad;
  for (const CellIndex c : mesh.live_cells())
    if (mesh.shape_of(c) < limit) bad.push_back(bad_cell(mesh, c));
  std::sort(bad.begin(), bad.end(), [](const BadCell& a, const BadCell& b) {
    return a.shape != b.shape ? a.shape < b.shape : a.cell < b.cell;
  });
  return bad;
}

std::vector<BadCell> cells_below_by_class(const DomainMesh& mesh, double limit, unsigned n_classes) {
  std::vector<std::vector<BadCell>> classes(n_classes);
  for (const CellIndex c : mesh.live_cells()) {
    const double shape = mesh.shape_of(c);
    if (!(shape < limit)) continue;
    const double place = std::max(shape / limit, 0.0) * n_classes;
    classes[std::min(static_cast<unsigned>(place), n_classes - 1)].push_back(bad_cell(mesh, c));
  }
  std::vector<BadCell> bad;
  for (const std::vector<BadCell>& of_class : classes) bad.insert(bad.end(), of_class.begin(), of_class.end());
  return bad;
}

bool is_left(const DomainMesh& mesh, const BadCell& b) {
  return mesh.is_live(b.cell) && mesh.vertices(b.cell) == b.vertices;
}

}  // namespace geomesh::remesh
