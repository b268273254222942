// SPDX-License-Identifier: MIT
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <mutex>

#include "common/parallel.hpp"
#include "remesh/operations/improve.hpp"
#include "remesh/passes/improve_passes.hpp"

namespace geomesh::remesh {

namespace {

constexpr std::size_t vertices_between_looks = 1024;  ///< at the clock
constexpr unsigned n_halvings = 3;
constexpr std::size_t least_to_part = 4096;  ///< vertices; fewer are one block

/// The vertices that may move, parted in space into blocks, and those between blocks. No vertex in a block shares a
/// cell with a vertex that may move and is in none or in another block: so blocks can be smoothed at once. Each in the
/// order of the cells.
class Blocks {
 public:
  explicit Blocks(const DomainMesh& mesh) : mesh_(mesh), block_(mesh.n_vertices(), fixed) {
    std::vector<VertexIndex> movable;
    for (VertexIndex v = 0; v < mesh.n_vertices(); ++v)
      if (mesh.kind(v) != VertexKind::dead && mesh.kind(v) != VertexKind::corner) movable.push_back(v);
    halve(movable, movable.size() < least_to_part ? 0 : n_halvings);
    part_from_neighbours();
    parts_.resize(n_blocks_);
    for (const VertexIndex v : mesh.vertices_by_cells())
      if (block_[v] == shared)
        between_.push_back(v);
      else if (block_[v] != fixed)
        parts_[block_[v]].push_back(v);
  }
  const std::vector<std::vector<VertexIndex>>& parts() const { return parts_; }
  const std::vector<VertexIndex>& between() const { return between_; }

 private:
  static constexpr std::uint8_t fixed = 255, shared = 254;

  /// By the median of the widest coordinate, again and again.
  void halve(std::span<VertexIndex> vertices, unsigned times) {
    if (times == 0) {
      for (const VertexIndex v : vertices) block_[v] = n_blocks_;
      ++n_blocks_;
      return;
    }
    const unsigned axis = widest_axis(vertices);
    const auto middle = vertices.begin() + static_cast<std::ptrdiff_t>(vertices.size() / 2);
    std::nth_element(vertices.begin(), middle, vertices.end(), [&](VertexIndex u, VertexIndex v) {
      const double x = mesh_.point(u)[axis], y = mesh_.point(v)[axis];
      return x != y ? x < y : u < v;
    });
    halve({vertices.begin(), middle}, times - 1);
    halve({middle, vertices.end()}, times - 1);
  }
  unsigned widest_axis(std::span<const VertexIndex> vertices) const {
    Vec3 low = mesh_.point(vertices[0]), high = low;
    for (const VertexIndex v : vertices)
      for (unsigned i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], mesh_.point(v)[i]);
        high[i] = std::max(high[i], mesh_.point(v)[i]);
      }
    unsigned axis = 0;
    for (unsigned i = 1; i < 3; ++i)
      if (high[i] - low[i] > high[axis] - low[axis]) axis = i;
    return axis;
  }

  void part_from_neighbours() {
    std::vector<std::uint8_t> beside_other(block_.size(), false);
    for (CellIndex c = 0; c < mesh_.n_slots(); ++c) {
      if (!mesh_.is_live(c)) continue;
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
  std::vector<std::uint8_t> block_;
  std::uint8_t n_blocks_ = 0;
  std::vector<std::vector<VertexIndex>> parts_;
  std::vector<VertexIndex> between_;
};

}  // namespace

void smooth_all(Toolbox& tools, const SmoothRule& rule, unsigned threads, const std::function<bool()>& out_of_time) {
  const Blocks blocks(tools.mesh);
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
