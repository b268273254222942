// SPDX-License-Identifier: MIT
// How many edges have the asked size, declared in remesh/sizes/sizes.hpp.
#include <algorithm>
#include <span>

#include "quality/measure/shape.hpp"
#include "remesh/sizes/sizes.hpp"

namespace geomesh::remesh {

namespace {

template <class Visit>
void for_each_cell_edge(const DomainMesh& mesh, const Visit& visit) {
  for (CellIndex c = 0; c < mesh.n_slots(); ++c)
    if (mesh.is_live(c))
      for (const auto& e : edge_vertices) {
        const VertexIndex a = mesh.vertices(c)[e[0]], b = mesh.vertices(c)[e[1]];
        visit(std::min(a, b), std::max(a, b));
      }
}

/// Calls visit(a, b) for each edge once, a < b: a counting sort by a, then short sorts.
template <class Visit>
void for_each_edge(const DomainMesh& mesh, const Visit& visit) {
  std::vector<std::size_t> first(mesh.n_vertices() + 1, 0);
  for_each_cell_edge(mesh, [&](VertexIndex a, VertexIndex) { ++first[a + 1]; });
  for (std::size_t v = 0; v < mesh.n_vertices(); ++v) first[v + 1] += first[v];
  std::vector<VertexIndex> upper(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for_each_cell_edge(mesh, [&](VertexIndex a, VertexIndex b) { upper[next[a]++] = b; });
  for (VertexIndex a = 0; a < mesh.n_vertices(); ++a) {
    const std::span<VertexIndex> ends = std::span(upper).subspan(first[a], first[a + 1] - first[a]);
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 0; k < ends.size(); ++k)
      if (k == 0 || ends[k] != ends[k - 1]) visit(a, ends[k]);
  }
}

}  // namespace

double share_of_edges_within_size(Toolbox& tools) {
  std::size_t n = 0, within = 0;
  for_each_edge(tools.mesh, [&](VertexIndex a, VertexIndex b) {
    const double ratio = distance(tools.mesh.point(a), tools.mesh.point(b)) / tools.size_of_edge(a, b);
    ++n;
    within += ratio >= 0.5 && ratio <= 2;
  });
  return n == 0 ? 1 : static_cast<double>(within) / static_cast<double>(n);
}

}  // namespace geomesh::remesh
