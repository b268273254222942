// SPDX-License-Identifier: MIT
// Computes how many edges have the requested size. Declared in remesh/sizes/sizes.hpp.
#include <algorithm>
#include <atomic>
#include <span>

#include "common/parallel.hpp"
#include "quality/measure/shape.hpp"
#include "remesh/sizes/sizes.hpp"

namespace geomesh::remesh {

namespace {

/// Calls visit(a, b) for the edges of all cells, with a < b, on several threads.
template <class Visit>
void for_each_cell_edge(const DomainMesh& mesh, unsigned threads, const Visit& visit) {
  for_each_index(mesh.n_slots(), threads, [&](std::size_t slot) {
    const auto c = static_cast<CellIndex>(slot);
    if (!mesh.is_live(c)) return;
    for (const auto& e : edge_vertices) {
      const VertexIndex a = mesh.vertices(c)[e[0]], b = mesh.vertices(c)[e[1]];
      visit(std::min(a, b), std::max(a, b));
    }
  });
}

/// For each vertex, its neighbours of higher index along edges. A neighbour is listed once for each cell at the edge,
/// in any order. Built by a counting sort.
struct EdgeEnds {
  EdgeEnds(const DomainMesh& mesh, unsigned threads) : first(mesh.n_vertices() + 1, 0) {
    const auto next_at = [](std::size_t& n) { return std::atomic_ref(n).fetch_add(1, std::memory_order_relaxed); };
    for_each_cell_edge(mesh, threads, [&](VertexIndex a, VertexIndex) { next_at(first[a + std::size_t{1}]); });
    for (std::size_t v = 0; v < mesh.n_vertices(); ++v) first[v + 1] += first[v];
    upper.grow_to(first.back());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for_each_cell_edge(mesh, threads, [&](VertexIndex a, VertexIndex b) { upper[next_at(next[a])] = b; });
  }
  std::vector<std::size_t> first;
  PodArray<VertexIndex> upper;
};

}  // namespace

double share_of_edges_within_size(Toolbox& tools, unsigned asked_threads) {
  const unsigned threads = thread_count(asked_threads);
  const DomainMesh& mesh = tools.mesh;
  tools.lengths.evaluate(threads);
  EdgeEnds edges(mesh, threads);
  std::atomic<std::size_t> n = 0, within = 0;
  for_each_index(mesh.n_vertices(), threads, [&](std::size_t v) {
    const auto a = static_cast<VertexIndex>(v);
    const std::span<VertexIndex> ends(edges.upper.data() + edges.first[v], edges.first[v + 1] - edges.first[v]);
    std::sort(ends.begin(), ends.end());
    const auto last = std::unique(ends.begin(), ends.end());
    std::size_t n_within = 0;
    for (auto b = ends.begin(); b != last; ++b) {
      const double ratio = tools.lengths.length(a, *b);
      n_within += ratio >= 0.5 && ratio <= 2;
    }
    n += static_cast<std::size_t>(last - ends.begin());
    within += n_within;
  });
  return n == 0 ? 1 : static_cast<double>(within) / static_cast<double>(n);
}

}  // namespace geomesh::remesh
