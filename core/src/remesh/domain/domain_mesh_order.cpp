// SPDX-License-Identifier: MIT
// Orders of a DomainMesh's cells and vertices in which what is near in space is near in memory.
#include <algorithm>

#include "mesh/spatial_order.hpp"
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

namespace {

template <class Value>
void permute(std::vector<Value>& values, const std::vector<CellIndex>& old_index) {
  std::vector<Value> sorted(old_index.size());
  for (std::size_t c = 0; c < old_index.size(); ++c) sorted[c] = values[old_index[c]];
  values = std::move(sorted);
}

/// Live cells by the least place of their vertices in `order`: a counting sort.
std::vector<CellIndex> cells_along(const TetMesh& mesh, const std::vector<VertexIndex>& order) {
  std::vector<Index> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<Index>(k);
  const auto place_of = [&](CellIndex c) {
    const Tetrahedron& t = mesh.vertices(c);
    return std::min({place[t[0]], place[t[1]], place[t[2]], place[t[3]]});
  };
  std::vector<CellIndex> next(order.size() + 1, 0), sorted(mesh.n_live());
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    if (mesh.is_live(c)) ++next[place_of(c) + 1];
  for (std::size_t k = 0; k < order.size(); ++k) next[k + 1] += next[k];
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    if (mesh.is_live(c)) sorted[next[place_of(c)]++] = c;
  return sorted;
}

}  // namespace

void DomainMesh::sort_cells() {
  const std::vector<CellIndex> old_index = cells_along(mesh_, hilbert_order(points_));
  std::vector<CellIndex> new_index(mesh_.n_slots(), no_cell);
  for (CellIndex c = 0; c < old_index.size(); ++c) new_index[old_index[c]] = c;
  TetMesh sorted;
  sorted.grow_to(old_index.size());
  for (CellIndex c = 0; c < old_index.size(); ++c) {
    TetMesh::Cell cell = mesh_.cells()[old_index[c]];
    for (FaceRef& n : cell.neighbors)
      if (n.valid()) n = FaceRef(new_index[n.cell()], n.face());
    sorted.cells()[c] = cell;
    sorted.flags(c) = mesh_.flags(old_index[c]);
  }
  mesh_ = std::move(sorted);
  permute(attributes_.component, old_index);
  permute(attributes_.tags, old_index);
  permute(attributes_.shape, old_index);
  for (CellIndex& c : cell_of_)
    if (c != no_cell) c = new_index[c];
}

std::vector<VertexIndex> DomainMesh::vertices_by_cells() const {
  std::vector<VertexIndex> vertices;
  std::vector<bool> seen(n_vertices(), false);
  for (const CellIndex c : live_cells())
    for (const VertexIndex v : mesh_.vertices(c))
      if (!seen[v]) seen[v] = true, vertices.push_back(v);
  return vertices;
}

}  // namespace geomesh::remesh
