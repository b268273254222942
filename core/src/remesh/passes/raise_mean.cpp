// SPDX-License-Identifier: MIT
// Raises the mean shape. Declared in remesh/passes/improve_passes.hpp.
#include <algorithm>

#include "quality/measure/shape.hpp"
#include "remesh/operations/improve.hpp"
#include "remesh/passes/block_pass.hpp"
#include "remesh/passes/improve_passes.hpp"

namespace geomesh::remesh {

namespace {

class MeanRaiser {
 public:
  MeanRaiser(Toolbox& tools, double floor, double poor)
      : tools_(tools), mesh_(tools.mesh), goal_{floor, mean_worth()}, is_left_(find_left(poor)) {}

  void run(unsigned smoothing_steps, const RunContext& context) {
    const std::uint64_t start = mesh_.tick();
    const auto is_left = [&](VertexIndex v) { return !is_left_.empty() && is_left_[v]; };
    BlockPass blocks(tools_, context);
    std::vector<VertexIndex> vertices = mesh_.vertices_by_cells();
    std::erase_if(vertices, is_left);
    blocks.run(std::move(vertices), tools_.block_rules.least_inside,
               [&](VertexIndex v, Toolbox& tools) { flip_about(v, tools); });
    blocks.note_counts("flips for the mean by blocks");
    SmoothRule rule;
    rule.max_steps = smoothing_steps;
    rule.goal = SmoothGoal::mean;
    rule.floor = goal_.floor;
    // If most cells are poor, raising the mean of all shapes is worth more time.
    rule.least_gain = tools_.bad_cells_may_spread ? 0.002 : 0.015;
    const auto go_on = [&] {
      context.check_cancelled();
      return false;
    };
    smooth_all(tools_, rule, context.threads, go_on,
               [&](VertexIndex v) { return is_left(v) && mesh_.changed_at(v) <= start; });
  }

 private:
  /// Returns, for each vertex, whether all cells at the vertex are good enough to be left alone.
  std::vector<bool> find_left(double poor) const {
    if (!(poor < 1)) return {};
    std::vector<bool> left(mesh_.n_vertices(), true);
    for (const CellIndex c : mesh_.live_cells())
      if (mesh_.shape_of(c) < poor)
        for (const VertexIndex v : mesh_.vertices(c)) left[v] = false;
    return left;
  }

  double mean_worth() const {
    double sum = 0;
    for (const CellIndex c : mesh_.live_cells()) sum += mesh_.measure().worth(mesh_.shape_of(c));
    return sum / static_cast<double>(mesh_.n_cells());
  }

  bool has_edge(CellIndex c, VertexIndex a, VertexIndex b) const {
    return mesh_.is_live(c) && mesh_.cells().has_vertex(c, a) && mesh_.cells().has_vertex(c, b);
  }

  /// Tries to remove the edges from v to vertices of higher index, so that each edge is examined once. The opposite
  /// flip, which replaces a face by an edge, hardly ever raises the mean shape: three cells about a new edge are worse
  /// than the two that they replace.
  void flip_about(VertexIndex v, Toolbox& tools) {
    auto& [star, edges] = lists_.local();
    mesh_.star(v, tools.work.marks, star);
    collect_edges(v, star, edges);
    for (const auto& [w, c] : edges)
      if (has_edge(c, v, w)) remove_edge_for_mean(tools, c, v, w, goal_);
  }

  /// Lists the edges from v to vertices of higher index, in ascending order, each with the first of its cells.
  void collect_edges(VertexIndex v, const std::vector<CellIndex>& star,
                     std::vector<std::pair<VertexIndex, CellIndex>>& edges) {
    edges.clear();
    for (const CellIndex c : star)
      for (const VertexIndex w : mesh_.vertices(c)) {
        if (w <= v) continue;
        const bool known = last_seen_[w].from == v;
        if (!known) last_seen_[w] = {v, static_cast<std::uint32_t>(edges.size())}, edges.push_back({w, c});
        CellIndex& first = edges[last_seen_[w].at].second;
        first = std::min(first, c);
      }
    std::sort(edges.begin(), edges.end());
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  MeanGoal goal_;
  std::vector<bool> is_left_;  // for each vertex, whether its cells are good enough to be left alone; empty: no
  struct Lists {
    std::vector<CellIndex> star;
    std::vector<std::pair<VertexIndex, CellIndex>> edges;
  };
  tbb::enumerable_thread_specific<Lists> lists_;
  struct Seen {
    VertexIndex from = no_vertex;
    std::uint32_t at = 0;  ///< in edges_
  };
  // For each vertex, the last listed edge that ends there; accessed only by the thread that visits its block.
  std::vector<Seen> last_seen_ = std::vector<Seen>(mesh_.n_vertices());
};

}  // namespace

void raise_mean(Toolbox& tools, double floor, unsigned smoothing_steps, const RunContext& context, double poor) {
  MeanRaiser(tools, floor, poor).run(smoothing_steps, context);
}

}  // namespace geomesh::remesh
