// SPDX-License-Identifier: MIT
// How many edges have the asked size, declared in remesh/sizes/sizes.hpp.
#include <algorithm>
#include <atomic>
#include <span>

#include "common/parallel.hpp"
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
/// By edge's lower vertex: the upper ones, once for each cell that has the edge.
struct EdgeEnds {
  explicit EdgeEnds(const DomainMesh& mesh) : first(mesh.n_vertices() + 1, 0) {
    for_each_cell_edge(mesh, [&](VertexIndex a, VertexIndex) { ++first[a + 1]; });
    for (std::size_t v = 0; v < mesh.n_vertices(); ++v) first[v + 1] += first[v];
    upper.resize(first.back());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for_each_cell_edge(mesh, [&](VertexIndex a, VertexIndex b) { upper[next[a]++] = b; });
  }
  std::vector<std::size_t> first;
  std::vector<VertexIndex> upper;
};

}  // namespace

double share_of_edges_within_size(Toolbox& tools, unsigned threads) {
  const DomainMesh& mesh = tools.mesh;
  tools.know_sizes(threads);
  EdgeEnds edges(mesh);
  std::atomic<std::size_t> n = 0, within = 0;
  for_each_index(mesh.n_vertices(), thread_count(threads), [&](std::size_t v) {
    const auto a = static_cast<VertexIndex>(v);
    const std::span<VertexIndex> ends =
        std::span(edges.upper).subspan(edges.first[v], edges.first[v + 1] - edges.first[v]);
    std::sort(ends.begin(), ends.end());
    const auto last = std::unique(ends.begin(), ends.end());
    std::size_t n_within = 0;
    for (auto b = ends.begin(); b != last; ++b) {
      const double ratio = distance(mesh.point(a), mesh.point(*b)) / tools.size_of_edge(a, *b);
      n_within += ratio >= 0.5 && ratio <= 2;
    }
    n += static_cast<std::size_t>(last - ends.begin());
    within += n_within;
  });
  return n == 0 ? 1 : static_cast<double>(within) / static_cast<double>(n);
}

}  // namespace geomesh::remesh
