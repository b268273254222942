// SPDX-License-Identifier: MIT
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>

#include "improve/improve.hpp"
#include "parallel.hpp"

namespace geomesh::remesh {

namespace {

constexpr std::size_t vertices_between_looks = 1024;  ///< at the clock
constexpr std::size_t task_size = 16;

bool may_move(const DomainMesh& mesh, VertexIndex v) {
  return mesh.kind(v) != VertexKind::dead && mesh.kind(v) != VertexKind::corner;
}

/// Vertices that may move, in groups: no two of a group share an edge, and of two that share an edge the one of lower index is in the
/// earlier group. So group after group, each in any order, is the same as one by one in ascending order.
class IndependentGroups {
 public:
  IndependentGroups(const DomainMesh& mesh, Workspace& work) {
    std::vector<std::uint32_t> group(mesh.n_vertices(), 0);
    for (VertexIndex v = 0; v < mesh.n_vertices(); ++v) {
      if (!may_move(mesh, v)) continue;
      group[v] = 1 + latest_before(mesh, v, group, work);
      if (group[v] >= first_.size()) first_.resize(group[v] + 1, 0);
      ++first_[group[v]];
    }
    sort_by(group);
  }
  std::size_t size() const { return first_.empty() ? 0 : first_.size() - 1; }
  std::span<const VertexIndex> operator[](std::size_t k) const {
    return std::span(vertices_).subspan(first_[k], first_[k + 1] - first_[k]);
  }

 private:
  static std::uint32_t latest_before(const DomainMesh& mesh, VertexIndex v, const std::vector<std::uint32_t>& group, Workspace& work) {
    std::uint32_t latest = 0;
    mesh.star(v, work.marks, work.cells);
    for (const CellIndex c : work.cells)
      for (const VertexIndex u : mesh.vertices(c))
        if (u < v) latest = std::max(latest, group[u]);
    return latest;
  }
  /// Counting sort; first_ holds the number in each group before, and where each begins afterwards.
  void sort_by(const std::vector<std::uint32_t>& group) {
    std::size_t begin = 0;
    for (std::size_t& n : first_) begin += std::exchange(n, begin);
    vertices_.resize(begin);
    std::vector<std::size_t> next = first_;
    for (VertexIndex v = 0; v < group.size(); ++v)
      if (group[v] > 0) vertices_[next[group[v]]++] = v;
    if (!first_.empty()) first_.erase(first_.begin()), first_.push_back(begin);
  }

  std::vector<std::size_t> first_;
  std::vector<VertexIndex> vertices_;
};

void smooth_one_by_one(Toolbox& tools, const SmoothRule& rule, const std::function<bool()>& out_of_time) {
  for (VertexIndex v = 0; v < tools.mesh.n_vertices(); ++v) {
    if (v % vertices_between_looks == 0 && out_of_time()) return;
    if (may_move(tools.mesh, v)) smooth_vertex(tools, v, rule);
  }
}

}  // namespace

void smooth_all(Toolbox& tools, const SmoothRule& rule, unsigned threads, const std::function<bool()>& out_of_time) {
  threads = thread_count(threads);
  if (threads == 1) return smooth_one_by_one(tools, rule, out_of_time);
  const IndependentGroups groups(tools.mesh, tools.work);
  tbb::enumerable_thread_specific<Workspace> scratch;
  std::atomic<std::size_t> moved = 0;
  std::size_t since_look = vertices_between_looks;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const std::span<const VertexIndex> group = groups[g];
    if ((since_look += group.size()) >= vertices_between_looks) {
      if (out_of_time()) break;
      since_look = 0;
    }
    for_each_task((group.size() + task_size - 1) / task_size, threads, [&](std::size_t k) {
      Workspace& work = scratch.local();
      std::size_t n = 0;
      for (const VertexIndex v : group.subspan(k * task_size, std::min(task_size, group.size() - k * task_size)))
        n += smooth_beside_others(tools, v, rule, work);
      moved += n;
    });
  }
  tools.statistics.smoothing_moves += moved;
}

}  // namespace geomesh::remesh
