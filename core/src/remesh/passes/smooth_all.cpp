// SPDX-License-Identifier: MIT
// One move of every vertex, on all cores, declared in remesh/passes/improve_passes.hpp.
#include <tbb/enumerable_thread_specific.h>

#include <atomic>
#include <mutex>

#include "common/parallel.hpp"
#include "remesh/operations/improve.hpp"
#include "remesh/passes/improve_passes.hpp"
#include "remesh/passes/vertex_blocks.hpp"

namespace geomesh::remesh {

namespace {

constexpr std::size_t vertices_between_looks = 1024;  ///< at the clock
std::vector<VertexIndex> movable_vertices(const DomainMesh& mesh) {
  std::vector<VertexIndex> movable;
  for (VertexIndex v = 0; v < mesh.n_vertices(); ++v)
    if (mesh.kind(v) != VertexKind::dead && mesh.kind(v) != VertexKind::corner) movable.push_back(v);
  return movable;
}

}  // namespace

void smooth_all(Toolbox& tools, const SmoothRule& rule, unsigned threads, const std::function<bool()>& out_of_time) {
  const VertexBlocks blocks(tools.mesh, movable_vertices(tools.mesh));
  std::atomic<std::size_t> moved = 0;
  std::atomic<bool> ended = false;
  std::mutex looking;
  tbb::enumerable_thread_specific<Workspace> scratch;
  const auto smooth = [&](const std::vector<VertexIndex>& vertices) {
    Workspace& work = scratch.local();
    std::size_t n = 0;
    for (std::size_t k = 0; k < vertices.size() && !ended; ++k) {
      if (k % vertices_between_looks == 0) {
        const std::lock_guard lock(looking);
        if (out_of_time()) ended = true;
      }
      n += smooth_beside_others(tools, vertices[k], rule, work);
    }
    moved += n;
  };
  for_each_task(blocks.parts().size(), thread_count(threads), [&](std::size_t k) { smooth(blocks.parts()[k]); });
  smooth(blocks.between());
  tools.statistics.smoothing_moves += moved;
}

}  // namespace geomesh::remesh
