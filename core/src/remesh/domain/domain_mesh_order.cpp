// SPDX-License-Identifier: MIT
// Sorts cells and vertices of a DomainMesh so that neighbours in space are neighbours in memory.
#include <algorithm>

#include "common/parallel.hpp"
#include "mesh/spatial_order.hpp"
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

namespace {

/// Number of cell slots to reserve, with some for blocks (mesh_blocks.hpp), so that no array is reallocated later.
std::size_t with_spare_slots(std::size_t n) { return n + n / 32; }

template <class Value>
void permute(PodArray<Value>& values, const std::vector<CellIndex>& old_index, unsigned threads) {
  PodArray<Value> sorted;
  sorted.reserve(with_spare_slots(old_index.size()));
  sorted.grow_to(old_index.size());
  for_each_index(old_index.size(), threads, [&](std::size_t c) { sorted[c] = values[old_index[c]]; });
  values = std::move(sorted);
}

/// Returns the live cells by the lowest position that one of their vertices has in `order` (counting sort).
std::vector<CellIndex> cells_along(const TetMesh& mesh, const std::vector<VertexIndex>& order, unsigned threads) {
  std::vector<Index> place(order.size()), place_of(mesh.n_slots());
  for (std::size_t k = 0; k < order.size(); ++k) place[order[k]] = static_cast<Index>(k);
  for_each_index(mesh.n_slots(), threads, [&](std::size_t c) {
    const Tetrahedron& t = mesh.vertices(static_cast<CellIndex>(c));
    place_of[c] = mesh.is_live(static_cast<CellIndex>(c))
                      ? std::min({place[t[0]], place[t[1]], place[t[2]], place[t[3]]})
                      : no_index;
  });
  std::vector<CellIndex> next(order.size() + 1, 0), sorted(mesh.n_live());
  for (const Index p : place_of)
    if (p != no_index) ++next[p + std::size_t{1}];
  for (std::size_t k = 0; k < order.size(); ++k) next[k + 1] += next[k];
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    if (place_of[c] != no_index) sorted[next[place_of[c]]++] = c;
  return sorted;
}

}  // namespace

void DomainMesh::sort_cells(unsigned asked_threads) {
  const unsigned threads = thread_count(asked_threads);
  const std::vector<CellIndex> old_index = cells_along(mesh_, hilbert_order(points_), threads);
  std::vector<CellIndex> new_index(mesh_.n_slots(), no_cell);
  for_each_index(old_index.size(), threads,
                 [&](std::size_t c) { new_index[old_index[c]] = static_cast<CellIndex>(c); });
  TetMesh sorted;
  sorted.reserve(with_spare_slots(old_index.size()));
  sorted.grow_to(old_index.size());
  for_each_index(old_index.size(), threads, [&](std::size_t c) {
    TetMesh::Cell cell = mesh_.cells()[old_index[c]];
    for (FaceRef& n : cell.neighbors)
      if (n.valid()) n = FaceRef(new_index[n.cell()], n.face());
    sorted.cells()[c] = cell;
    sorted.cell_flags()[c] = mesh_.flags(old_index[c]);
  });
  mesh_ = std::move(sorted);
  permute(attributes_.component, old_index, threads);
  permute(attributes_.tags, old_index, threads);
  permute(attributes_.shape, old_index, threads);
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
