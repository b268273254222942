// SPDX-License-Identifier: MIT
// Passes over edges of surfaces: split, flip, contract. Declared in remesh/passes/passes.hpp.
#include <algorithm>
#include <cmath>
#include <queue>

#include "common/geometry.hpp"
#include "common/parallel.hpp"
#include "remesh/operations/improve.hpp"
#include "remesh/operations/refine_ratios.hpp"
#include "remesh/passes/passes.hpp"

namespace geomesh::remesh {

namespace {

struct MeasuredEdge {
  double ratio;  ///< length relative to the target size
  VertexIndex a, b;
  bool operator<(const MeasuredEdge& o) const {
    return ratio != o.ratio ? ratio < o.ratio : std::pair(a, b) > std::pair(o.a, o.b);
  }
};

bool on_constrained_face(const DomainMesh& mesh, CellIndex c, unsigned i, unsigned j) {
  for (unsigned k = 0; k < 4; ++k)
    if (k != i && k != j && mesh.tag(c, k).constrained()) return true;
  return false;
}

CellIndex cell_with_edge(Toolbox& tools, VertexIndex a, VertexIndex b) {
  tools.mesh.star(a, tools.work.marks, tools.work.cells);
  for (const CellIndex c : tools.work.cells)
    if (tools.mesh.cells().has_vertex(c, b)) return c;
  return no_cell;
}

class EdgeSplitter {
 public:
  EdgeSplitter(Toolbox& tools, LongEdges which)
      : tools_(tools),
        mesh_(tools.mesh),
        which_(which),
        may_flip_(which == LongEdges::of_surfaces && tools.guard.exact()) {}

  std::size_t run(std::size_t max_cells, const RunContext& context) {
    for (const CellIndex c : mesh_.live_cells()) push_edges(c, no_vertex);
    std::size_t n = 0;
    while (!queue_.empty()) {
      const MeasuredEdge e = queue_.top();
      queue_.pop();
      if (n % 256 == 0) context.check_cancelled(), context.report(mesh_.n_cells(), 0);
      const CellIndex c = cell_with_edge(tools_, e.a, e.b);
      if (c == no_cell || !is_asked(c, e.a, e.b)) continue;
      if (may_flip_ && flip_surface_edge(tools_, c, e.a, e.b, refine_ratios.surface_shape)) {
        push_created(no_vertex);
        continue;
      }
      if (may_flip_ && is_within_hair(c, e.a, e.b)) continue;
      const auto v = split_edge(tools_, c, e.a, e.b);
      if (!v) continue;
      ++n;
      if (mesh_.n_cells() > max_cells) throw_too_many_cells(max_cells);
      push_created(*v);
    }
    return n;
  }

 private:
  /// Finds the constrained faces at an edge; c is any cell at the edge.
  EdgeFaces look_about(CellIndex c, VertexIndex a, VertexIndex b) {
    const bool closed = turn_about_edge(mesh_.cells(), c, a, b, cells_, ring_);
    return constrained_faces_of_ring(mesh_, cells_, ring_, closed);
  }

  bool is_asked(CellIndex c, VertexIndex a, VertexIndex b) {
    if (which_ == LongEdges::of_curves) return mesh_.curve_of(a, b) != no_index;
    return look_about(c, a, b).n > 0;
  }

  /// Returns whether both faces at the edge belong to a strip of triangles so thin that points between its borders
  /// would not help: if the edges in the strip cannot be flipped, each half of an edge would make two more long edges.
  bool is_within_hair(CellIndex c, VertexIndex a, VertexIndex b) {
    const EdgeFaces faces = look_about(c, a, b);
    const Vec3 &p = mesh_.point(a), along = mesh_.point(b) - p;
    const double limit = tools_.lengths.absolute(a, b, refine_ratios.hair) * length(along);
    return faces.n == 2 && std::all_of(faces.at.begin(), faces.at.end(), [&](std::size_t k) {
             return length(cross(along, mesh_.point(ring_[k]) - p)) <= limit;
           });
  }

  void push_created(VertexIndex only) {
    const std::vector<CellIndex> created = tools_.work.created;
    for (const CellIndex c : created) push_edges(c, only);
  }

  void push_edges(CellIndex c, VertexIndex only) {
    const Tetrahedron& t = mesh_.vertices(c);
    for (const auto& e : edge_vertices) {
      const auto [a, b] = sorted(std::array{t[e[0]], t[e[1]]});
      if (only != no_vertex && a != only && b != only && !on_constrained_face(mesh_, c, e[0], e[1])) continue;
      const bool is_of_curve = mesh_.curve_of(a, b) != no_index;
      if (which_ == LongEdges::of_curves ? !is_of_curve : !on_constrained_face(mesh_, c, e[0], e[1])) continue;
      const double ratio = tools_.lengths.length(a, b);
      if (ratio > refine_ratios.split_edge) queue_.push({ratio, a, b});
    }
  }

  Toolbox& tools_;
  DomainMesh& mesh_;
  LongEdges which_;
  bool may_flip_;  ///< whether a long edge on a planar patch is flipped instead of split, if possible
  std::priority_queue<MeasuredEdge> queue_;
  std::vector<CellIndex> cells_;  // cells around the edge examined last
  std::vector<VertexIndex> ring_;
};

/// Returns the edges shorter than `ratio` times their target size, the shortest first, around which the mesh has
/// changed after its time `since` (DomainMesh::tick). Runs on all cores.
std::vector<MeasuredEdge> short_edges(Toolbox& tools, ShortEdges which, double ratio, std::uint64_t since,
                                      const RunContext& context) {
  constexpr std::size_t chunk = 16384;
  const DomainMesh& mesh = tools.mesh;
  tools.lengths.evaluate(context.threads);
  std::vector<std::vector<MeasuredEdge>> found((mesh.n_slots() + chunk - 1) / chunk);
  for_each_task(found.size(), thread_count(context.threads), [&](std::size_t k) {
    const auto end = static_cast<CellIndex>(std::min<std::size_t>(mesh.n_slots(), (k + 1) * chunk));
    for (auto c = static_cast<CellIndex>(k * chunk); c < end; ++c) {
      if (!mesh.is_live(c)) continue;
      const Tetrahedron& t = mesh.vertices(c);
      for (const auto& e : edge_vertices) {
        const VertexIndex a = std::min(t[e[0]], t[e[1]]), b = std::max(t[e[0]], t[e[1]]);
        const bool is_inside = mesh.kind(a) == VertexKind::inside || mesh.kind(b) == VertexKind::inside;
        if (is_inside != (which == ShortEdges::inside)) continue;
        if (since > 0 && std::max(mesh.changed_at(a), mesh.changed_at(b)) <= since) continue;
        if (tools.lengths.is_shorter(a, b, ratio)) found[k].push_back({tools.lengths.length(a, b), a, b});
      }
    }
  });
  std::vector<MeasuredEdge> edges;
  for (const auto& of_chunk : found) edges.insert(edges.end(), of_chunk.begin(), of_chunk.end());
  const auto key = [](const MeasuredEdge& e) { return std::tuple(e.ratio, e.a, e.b); };
  std::sort(edges.begin(), edges.end(), [&](const MeasuredEdge& x, const MeasuredEdge& y) { return key(x) < key(y); });
  edges.erase(std::unique(edges.begin(), edges.end(),
                          [](const MeasuredEdge& x, const MeasuredEdge& y) { return x.a == y.a && x.b == y.b; }),
              edges.end());
  return edges;
}

/// Contracts short edges by calling `collapse`, which moves a vertex to another one if possible.
template <class Collapse>
std::size_t collapse_edges(Toolbox& tools, const std::vector<MeasuredEdge>& edges, const RunContext& context,
                           const Collapse& collapse) {
  DomainMesh& mesh = tools.mesh;
  std::size_t n = 0;
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (k % 256 == 0) context.check_cancelled(), context.report(mesh.n_cells(), 0);
    VertexIndex u = edges[k].a, v = edges[k].b;
    if (mesh.kind(u) == VertexKind::dead || mesh.kind(v) == VertexKind::dead) continue;
    if (mesh.kind(u) < mesh.kind(v)) std::swap(u, v);  // contraction removes the less constrained end u of the edge
    if (cell_with_edge(tools, u, v) == no_cell) continue;
    if (collapse(u, v) || collapse(v, u)) ++n;
  }
  return n;
}

}  // namespace

void throw_too_many_cells(std::size_t max_cells) {
  throw Error(ErrorKind::cannot_mesh,
              "refinement reached the limit of " + std::to_string(max_cells) +
                  " elements before the requested sizes; choose larger sizes or raise the limit");
}

std::size_t split_long_edges(Toolbox& tools, LongEdges which, std::size_t max_cells, const RunContext& context) {
  return EdgeSplitter(tools, which).run(max_cells, context);
}

std::size_t collapse_short_edges(Toolbox& tools, ShortEdges which, const RunContext& context) {
  const std::vector<MeasuredEdge> edges = short_edges(tools, which, refine_ratios.collapse_edge, 0, context);
  return collapse_edges(tools, edges, context, [&](VertexIndex u, VertexIndex v) {
    return try_collapse(tools, u, v, CollapseRule::coarsen, refine_ratios.collapse_floor);
  });
}

std::size_t thin_out(Toolbox& tools, ShortEdges which, double floor, std::uint64_t since, const RunContext& context) {
  const bool is_inside = which == ShortEdges::inside;
  const double ratio = is_inside ? refine_ratios.thin_out_edge : refine_ratios.thin_out_surface_edge;
  const std::vector<MeasuredEdge> edges = short_edges(tools, which, ratio, since, context);
  return collapse_edges(tools, edges, context, [&](VertexIndex u, VertexIndex v) {
    return try_collapse(tools, u, v, CollapseRule::thin_out, floor);
  });
}

std::size_t thin_out_mending(Toolbox& tools, ShortEdges which, const RescueRule& rule, std::uint64_t since,
                             const RunContext& context) {
  const std::vector<MeasuredEdge> edges = short_edges(tools, which, refine_ratios.promised_edge, since, context);
  const std::size_t n = collapse_edges(
      tools, edges, context, [&](VertexIndex u, VertexIndex v) { return collapse_mending(tools, u, v, rule); });
  return n + collapse_edges(tools, edges, context, [&](VertexIndex u, VertexIndex v) {
           constexpr double wanted = refine_ratios.stretched_edge;
           return tools.lengths.is_shorter(u, v, wanted) &&
                  stretch_mending(tools, u, v, tools.lengths.absolute(u, v, wanted), rule);
         });
}

}  // namespace geomesh::remesh
