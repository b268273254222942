// SPDX-License-Identifier: MIT
#include "remesh/passes/surface_regularizer.hpp"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>

#include "common/parallel.hpp"
#include "remesh/operations/refine_ratios.hpp"
#include "remesh/passes/vertex_blocks.hpp"

namespace geomesh::remesh {

void SurfaceRegularizer::run(const RunContext& context) {
  flips_in_vain_.resize(mesh_.n_vertices(), 0);
  moves_in_vain_.resize(mesh_.n_vertices(), 0);
  for (unsigned round = 0; round < refine_ratios.regular_rounds; ++round) {
    context.check_cancelled();
    std::size_t n = 0;
    for (VertexIndex v = 0; v < mesh_.n_vertices(); ++v)
      if (mesh_.kind(v) <= VertexKind::surface && flips_in_vain_[v] < mesh_.changed_at(v)) n += flip_about(v);
    n += move_all(context.threads);
    if (n == 0) break;
  }
}

/// A vertex that stays is not tried again before something about it changes after this call.
std::size_t SurfaceRegularizer::move_all(unsigned threads) {
  std::vector<VertexIndex> asked;
  for (VertexIndex v = 0; v < mesh_.n_vertices(); ++v)
    if (mesh_.kind(v) == VertexKind::surface && moves_in_vain_[v] < mesh_.changed_at(v)) asked.push_back(v);
  const VertexBlocks blocks(mesh_, std::move(asked));
  const std::uint64_t before = mesh_.tick();
  std::atomic<std::size_t> n_moved = 0;
  tbb::enumerable_thread_specific<Workspace> scratch;
  const auto move = [&](const std::vector<VertexIndex>& vertices) {
    std::size_t n = 0;
    for (const VertexIndex v : vertices)
      if (smooth_on_surface(tools_, v, refine_ratios.regular_floor, scratch.local()))
        ++n;
      else
        moves_in_vain_[v] = before;
    n_moved += n;
  };
  for_each_task(blocks.parts().size(), thread_count(threads), [&](std::size_t k) { move(blocks.parts()[k]); });
  move(blocks.between());
  tools_.statistics.smoothing_moves += n_moved;
  return n_moved;
}

/// Edges to greater vertices, so that each is looked at once.
std::size_t SurfaceRegularizer::flip_about(VertexIndex v) {
  mesh_.star(v, tools_.work.marks, star_);
  collect_edges(v);
  std::size_t n = 0;
  for (const SurfaceEdge& e : edges_) {
    const TetMesh& cells = mesh_.topology();
    if (!is_asked(v, e) || !mesh_.is_live(e.cell) || !cells.has_vertex(e.cell, v) || !cells.has_vertex(e.cell, e.to))
      continue;
    n += flip_surface_edge(tools_, e.cell, v, e.to, refine_ratios.regular_floor);
  }
  if (n == 0) flips_in_vain_[v] = mesh_.tick();
  return n;
}

/// A face with two cells is taken from above.
void SurfaceRegularizer::collect_edges(VertexIndex v) {
  edges_.clear();
  for (const CellIndex c : star_) {
    const Tetrahedron& t = mesh_.vertices(c);
    for (unsigned i = 0; i < 4; ++i) {
      const FaceTag tag = mesh_.tag(c, i);
      if (!tag.constrained() || t[i] == v || (!tag.above() && mesh_.has_neighbor(c, i))) continue;
      const auto& f = face_vertices[i];
      const unsigned k = t[f[0]] == v ? 0 : t[f[1]] == v ? 1 : 2;
      const VertexIndex x = t[f[(k + 1) % 3]], y = t[f[(k + 2) % 3]];
      if (x > v) add_edge(x, y, c);
      if (y > v) add_edge(y, x, c);
    }
  }
}

void SurfaceRegularizer::add_edge(VertexIndex to, VertexIndex apex, CellIndex cell) {
  const auto known = std::find_if(edges_.begin(), edges_.end(), [to](const SurfaceEdge& e) { return e.to == to; });
  if (known == edges_.end()) {
    edges_.push_back({to, cell, apex, no_vertex, 1});
  } else {
    known->other_apex = apex;
    ++known->n_faces;
  }
}

/// Two faces, and not Delaunay on the surface.
bool SurfaceRegularizer::is_asked(VertexIndex v, const SurfaceEdge& e) const {
  return e.n_faces == 2 && surface_asks_for_flip(mesh_, v, e.to, e.apex, e.other_apex);
}

}  // namespace geomesh::remesh
