// SPDX-License-Identifier: MIT
// Faces of good shape within patches, declared in remesh/passes/passes.hpp.
#include <algorithm>
#include <atomic>

#include "remesh/operations/improve.hpp"
#include "remesh/operations/refine_ratios.hpp"
#include "remesh/passes/passes.hpp"

namespace geomesh::remesh {

namespace {

class SurfaceRegularizer {
 public:
  SurfaceRegularizer(Toolbox& tools, InVainOnSurfaces& in_vain) : tools_(tools), mesh_(tools.mesh), in_vain_(in_vain) {
    in_vain_.flips.resize(mesh_.n_vertices(), 0);
    in_vain_.moves.resize(mesh_.n_vertices(), 0);
  }

  std::size_t flip_all() {
    std::size_t n = 0;
    for (VertexIndex v = 0; v < mesh_.n_vertices(); ++v)
      if (mesh_.kind(v) <= VertexKind::surface && in_vain_.flips[v] < mesh_.changed_at(v)) n += flip_about(v);
    return n;
  }

  /// A vertex that stays is not tried again before something about it changes after this call.
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
  /// An edge from a vertex to a greater one, and the apexes of its faces.
  struct SurfaceEdge {
    VertexIndex to;
    CellIndex cell;
    VertexIndex apex, other_apex;
    unsigned n_faces;
  };

  /// Edges to greater vertices, so that each is looked at once.
  std::size_t flip_about(VertexIndex v) {
    mesh_.star(v, tools_.work.marks, star_);
    collect_edges(v);
    std::size_t n = 0;
    for (const SurfaceEdge& e : edges_) {
      const TetMesh& cells = mesh_.cells();
      if (!is_asked(v, e) || !mesh_.is_live(e.cell) || !cells.has_vertex(e.cell, v) || !cells.has_vertex(e.cell, e.to))
        continue;
      n += flip_surface_edge(tools_, e.cell, v, e.to, refine_ratios.regular_floor);
    }
    if (n == 0) in_vain_.flips[v] = mesh_.tick();
    return n;
  }

  void collect_edges(VertexIndex v) {
    edges_.clear();
    for (const CellIndex c : star_)
      for (unsigned i = 0; i < 4; ++i) {
        if (!mesh_.is_surface(FaceRef(c, i)) || mesh_.vertices(c)[i] == v) continue;
        const Triangle f = mesh_.face(c, i);
        const unsigned k = f[0] == v ? 0 : f[1] == v ? 1 : 2;
        const VertexIndex x = f[(k + 1) % 3], y = f[(k + 2) % 3];
        if (x > v) add_edge(x, y, c);
        if (y > v) add_edge(y, x, c);
      }
  }

  void add_edge(VertexIndex to, VertexIndex apex, CellIndex cell) {
    const auto known = std::find_if(edges_.begin(), edges_.end(), [to](const SurfaceEdge& e) { return e.to == to; });
    if (known == edges_.end()) {
      edges_.push_back({to, cell, apex, no_vertex, 1});
    } else {
      known->other_apex = apex;
      ++known->n_faces;
    }
  }

  /// Two faces, and not Delaunay on the surface.
  bool is_asked(VertexIndex v, const SurfaceEdge& e) const {
    return e.n_faces == 2 && surface_asks_for_flip(mesh_, v, e.to, e.apex, e.other_apex);
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  InVainOnSurfaces& in_vain_;
  std::vector<CellIndex> star_;
  std::vector<SurfaceEdge> edges_;
};

}  // namespace

void make_surfaces_regular(Toolbox& tools, InVainOnSurfaces& in_vain, const RunContext& context) {
  SurfaceRegularizer regularizer(tools, in_vain);
  for (unsigned round = 0; round < refine_ratios.regular_rounds; ++round) {
    context.check_cancelled();
    context.report(tools.mesh.n_cells(), 0);
    const std::size_t n_flips = regularizer.flip_all();
    if (n_flips + regularizer.move_all(context.threads) == 0) break;
  }
}

}  // namespace geomesh::remesh
