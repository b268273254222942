// SPDX-License-Identifier: MIT
// Smooths vertices concurrently. Declared in remesh/passes/passes.hpp and remesh/passes/improve_passes.hpp.
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <mutex>

#include "common/parallel.hpp"
#include "remesh/operations/improve.hpp"
#include "remesh/passes/improve_passes.hpp"
#include "remesh/passes/passes.hpp"

namespace geomesh::remesh {

namespace {

constexpr unsigned n_halvings = 3;
constexpr std::size_t least_to_part = 4096;  ///< fewer vertices than this are not divided into blocks for threads
constexpr std::uint8_t fixed = 255, shared = 254;
constexpr std::size_t vertices_between_looks = 1024;  ///< at the clock

/// Divides vertices into blocks, such that no vertex of a block shares a cell with a vertex outside it. Vertices of
/// each block are in the order of the cells. Blocks depend only on the mesh. O(n).
class VertexBlocks {
 public:
  VertexBlocks(const DomainMesh& mesh, std::vector<VertexIndex> movable)
      : mesh_(mesh), block_(mesh.n_vertices(), fixed) {
    halve(movable, movable.size() < least_to_part ? 0 : n_halvings);
    part_from_neighbours();
    parts.resize(n_blocks_);
    for (const VertexIndex v : mesh.vertices_by_cells())
      if (block_[v] == shared)
        between.push_back(v);
      else if (block_[v] != fixed)
        parts[block_[v]].push_back(v);
  }
  std::vector<std::vector<VertexIndex>> parts;
  std::vector<VertexIndex> between;

 private:
  /// Bisects a set of vertices recursively, at the median of the coordinate with the largest extent.
  void halve(std::span<VertexIndex> vertices, unsigned times) {
    if (times == 0) {
      for (const VertexIndex v : vertices) block_[v] = n_blocks_;
      ++n_blocks_;
      return;
    }
    Box3 box;
    for (const VertexIndex v : vertices) box.add(mesh_.point(v));
    const Vec3 extent = box.max - box.min;
    const std::size_t axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const auto middle = vertices.begin() + static_cast<std::ptrdiff_t>(vertices.size() / 2);
    std::nth_element(vertices.begin(), middle, vertices.end(), [&](VertexIndex u, VertexIndex v) {
      const double x = mesh_.point(u)[axis], y = mesh_.point(v)[axis];
      return x != y ? x < y : u < v;
    });
    halve({vertices.begin(), middle}, times - 1);
    halve({middle, vertices.end()}, times - 1);
  }

  void part_from_neighbours() {
    std::vector<std::uint8_t> beside_other(block_.size(), false);
    for (const CellIndex c : mesh_.live_cells()) {
      std::uint8_t first = fixed;
      bool mixed = false;
      for (const VertexIndex v : mesh_.vertices(c)) {
        if (block_[v] == fixed) continue;
        if (first == fixed) first = block_[v];
        mixed |= block_[v] != first;
      }
      if (!mixed) continue;
      for (const VertexIndex v : mesh_.vertices(c)) beside_other[v] = true;
    }
    for (VertexIndex v = 0; v < block_.size(); ++v)
      if (beside_other[v] && block_[v] != fixed) block_[v] = shared;
  }

  const DomainMesh& mesh_;
  std::vector<std::uint8_t> block_;  // by vertex
  std::uint8_t n_blocks_ = 0;
};

}  // namespace

void for_each_block(const DomainMesh& mesh, std::vector<VertexIndex> movable, unsigned threads,
                    const std::function<void(const std::vector<VertexIndex>&, Workspace&)>& visit) {
  const VertexBlocks blocks(mesh, std::move(movable));
  tbb::enumerable_thread_specific<Workspace> scratch;
  for_each_task(blocks.parts.size(), thread_count(threads),
                [&](std::size_t k) { visit(blocks.parts[k], scratch.local()); });
  visit(blocks.between, scratch.local());
}

void smooth_all(Toolbox& tools, const SmoothRule& rule, unsigned threads, const std::function<bool()>& out_of_time,
                const std::function<bool(VertexIndex)>& leaves) {
  std::vector<VertexIndex> movable;
  for (VertexIndex v = 0; v < tools.mesh.n_vertices(); ++v)
    if (tools.mesh.kind(v) != VertexKind::dead && tools.mesh.kind(v) != VertexKind::corner && !(leaves && leaves(v)))
      movable.push_back(v);
  tools.make_room_for_normals();
  std::atomic<std::size_t> moved = 0;
  std::atomic<bool> ended = false;
  std::mutex looking;
  for_each_block(tools.mesh, std::move(movable), threads,
                 [&](const std::vector<VertexIndex>& vertices, Workspace& work) {
                   std::size_t n = 0;
                   for (std::size_t k = 0; k < vertices.size() && !ended; ++k) {
                     if (k % vertices_between_looks == 0) {
                       const std::lock_guard lock(looking);
                       if (out_of_time()) ended = true;
                     }
                     n += smooth_beside_others(tools, vertices[k], rule, work);
                   }
                   moved += n;
                 });
  tools.statistics.smoothing_moves += moved;
}

}  // namespace geomesh::remesh
