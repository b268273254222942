// SPDX-License-Identifier: MIT
// Improves the shapes of faces within patches. Declared in remesh/passes/passes.hpp.
#include <algorithm>
#include <atomic>

#include "remesh/operations/improve.hpp"
#include "remesh/operations/refine_ratios.hpp"
#include "remesh/passes/block_pass.hpp"
#include "remesh/passes/passes.hpp"

namespace geomesh::remesh {

namespace {

class SurfaceRegularizer {
 public:
  SurfaceRegularizer(Toolbox& tools, InVainOnSurfaces& in_vain, const RunContext& context)
      : tools_(tools), mesh_(tools.mesh), in_vain_(in_vain), blocks_(tools, context) {
    in_vain_.flips.resize(mesh_.n_vertices(), 0);
    in_vain_.moves.resize(mesh_.n_vertices(), 0);
  }

  std::size_t flip_all() {
    const std::size_t before = tools_.statistics.edge_removals;
    std::vector<VertexIndex> asked;
    for (VertexIndex v = 0; v < mesh_.n_vertices(); ++v)
      if (mesh_.kind(v) <= VertexKind::surface) asked.push_back(v);
    blocks_.run(std::move(asked), tools_.block_rules.least_on_surfaces, [&](VertexIndex v, Toolbox& tools) {
      if (in_vain_.flips[v] < mesh_.changed_at(v)) flip_about(v, tools);
    });
    return tools_.statistics.edge_removals - before;
  }

  void note_counts() const { blocks_.note_counts("flips on surfaces by blocks"); }

  /// Moves vertices within patches. One that cannot move is tried again only after something around it has changed.
  std::size_t move_all(unsigned threads) {
    std::vector<VertexIndex> asked;
    for (VertexIndex v = 0; v < mesh_.n_vertices(); ++v)
      if (mesh_.kind(v) == VertexKind::surface && in_vain_.moves[v] < mesh_.changed_at(v)) asked.push_back(v);
    const std::uint64_t before = mesh_.tick();
    std::atomic<std::size_t> n = 0;
    for_each_block(mesh_, std::move(asked), threads, [&](const std::vector<VertexIndex>& vertices, Workspace& work) {
      for (const VertexIndex v : vertices)
        if (smooth_on_surface(tools_, v, refine_ratios.regular_floor, work))
          ++n;
        else
          in_vain_.moves[v] = before;
    });
    tools_.statistics.smoothing_moves += n;
    return n;
  }

 private:
  /// An edge from a vertex to one of higher index, and the opposite vertices of its two faces.
  struct SurfaceEdge {
    VertexIndex to;
    CellIndex cell;
    VertexIndex apex, other_apex;
    unsigned n_faces;
  };

  /// Flips edges from v to vertices of higher index, so that each edge is examined once.
  void flip_about(VertexIndex v, Toolbox& tools) {
    auto& [star, edges] = lists_.local();
    mesh_.star(v, tools.work.marks, star);
    collect_edges(v, star, edges);
    const std::size_t before = tools.statistics.edge_removals;
    for (const SurfaceEdge& e : edges) {
      const TetMesh& cells = mesh_.cells();
      if (!is_asked(v, e) || !mesh_.is_live(e.cell) || !cells.has_vertex(e.cell, v) || !cells.has_vertex(e.cell, e.to))
        continue;
      flip_surface_edge(tools, e.cell, v, e.to, refine_ratios.regular_floor);
    }
    if (tools.statistics.edge_removals == before) in_vain_.flips[v] = tools.tick();
  }

  void collect_edges(VertexIndex v, const std::vector<CellIndex>& star, std::vector<SurfaceEdge>& edges) const {
    edges.clear();
    for (const CellIndex c : star)
      for (unsigned i = 0; i < 4; ++i) {
        if (!mesh_.is_surface(FaceRef(c, i)) || mesh_.vertices(c)[i] == v) continue;
        const Triangle f = mesh_.face(c, i);
        const unsigned k = f[0] == v ? 0 : f[1] == v ? 1 : 2;
        const VertexIndex x = f[(k + 1) % 3], y = f[(k + 2) % 3];
        if (x > v) add_edge(edges, x, y, c);
        if (y > v) add_edge(edges, y, x, c);
      }
  }

  static void add_edge(std::vector<SurfaceEdge>& edges, VertexIndex to, VertexIndex apex, CellIndex cell) {
    const auto known = std::find_if(edges.begin(), edges.end(), [to](const SurfaceEdge& e) { return e.to == to; });
    if (known == edges.end()) {
      edges.push_back({to, cell, apex, no_vertex, 1});
    } else {
      known->other_apex = apex;
      ++known->n_faces;
    }
  }

  /// Returns whether the edge has two faces and is not Delaunay on the surface.
  bool is_asked(VertexIndex v, const SurfaceEdge& e) const {
    return e.n_faces == 2 && surface_asks_for_flip(mesh_, v, e.to, e.apex, e.other_apex);
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  InVainOnSurfaces& in_vain_;
  struct Lists {
    std::vector<CellIndex> star;
    std::vector<SurfaceEdge> edges;
  };
  tbb::enumerable_thread_specific<Lists> lists_;
  BlockPass blocks_;
};

}  // namespace

void make_surfaces_regular(Toolbox& tools, InVainOnSurfaces& in_vain, const RunContext& context) {
  SurfaceRegularizer regularizer(tools, in_vain, context);
  for (unsigned round = 0; round < refine_ratios.regular_rounds; ++round) {
    context.check_cancelled();
    context.report(tools.mesh.n_cells(), 0);
    const std::size_t n_flips = regularizer.flip_all();
    if (n_flips + regularizer.move_all(context.threads) == 0) break;
  }
  regularizer.note_counts();
}

}  // namespace geomesh::remesh
