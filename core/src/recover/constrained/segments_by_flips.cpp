// SPDX-License-Identifier: MIT
/// Recovers missing segments by flips alone: the first simplex that the segment crosses is removed, alternately from
/// both ends (after the boundary recovery of George and Borouchaki 1998 and of Si 2015; own design on the n-to-m
/// removal of edge_removal.hpp).
#include "recover/model/crossing.hpp"
#include "recover/model/messages.hpp"
#include "recover/model/recover.hpp"
#include "recover/model/recovery_budget.hpp"
#include "recover/operations/edge_removal.hpp"

namespace geomesh::recover {

namespace {

/// Removes by flips the mesh face or edge that a segment crosses, or an edge beside it that prevents this.
bool remove_crossed(Recovery& recovery, EdgeRemover& remover, const Crossing& crossing, unsigned depth) {
  ConstrainedMesh& mesh = recovery.mesh;
  if (crossing.kind == CrossingKind::edge)
    return remover.remove(crossing.v[0], crossing.v[1], depth, nullptr, recovery_budget.edges_by_depth[depth],
                          crossing.cell);
  if (remover.flip_face(crossing.face)) return true;
  const FaceRef beyond = mesh.cells().mirror(crossing.face);
  const VertexIndex a = mesh.cells().vertex(crossing.cell, crossing.face.face());
  const VertexIndex d = mesh.cells().vertex(beyond.cell(), beyond.face());
  const auto v = crossing.v;  // vertices of the crossed face, counter-clockwise as seen from a
  for (unsigned k = 0; k < 3; ++k) {
    const VertexIndex p = v[k], q = v[(k + 1) % 3];
    if (mesh.orient(p, q, d, a) == Sign::positive) continue;
    if (remover.remove(p, q, depth, nullptr, recovery_budget.edges_by_depth[depth], crossing.cell)) return true;
  }
  return false;
}

}  // namespace

namespace {

/// Repeatedly removes the first mesh face or edge that the missing edge a-b crosses, alternately from both ends.
bool recover_from_ends(Recovery& recovery, VertexIndex a, VertexIndex b, unsigned depth, std::size_t& work_left) {
  EdgeRemover remover(recovery.mesh, recovery.constraints, &work_left);
  unsigned failures = 0;
  for (unsigned step = 0; step < recovery_budget.flips_of_segment && failures < 2; ++step) {
    const Crossing crossing = first_crossing(recovery.mesh, a, b);
    if (crossing.kind == CrossingKind::edge_present) return true;
    const Index s = recovery.constraints.subsegment_of(a, b);
    if (crossing.kind == CrossingKind::vertex) {
      recovery.end(error_of_vertex_on_segment(recovery, crossing.v[0], s));
      return false;
    }
    if (crossing.kind == CrossingKind::edge) {
      const Index other = recovery.constraints.subsegment_of(crossing.v[0], crossing.v[1]);
      if (other != no_index) {
        recovery.end(error_of_segments_cross(recovery, s, other));
        return false;
      }
    }
    if (remove_crossed(recovery, remover, crossing, depth)) {
      failures = 0;
    } else {
      ++failures;
      std::swap(a, b);
    }
  }
  return false;
}

/// Removes the mesh faces and edges that the missing edge a-b crosses by flips, one after the other in any order. A
/// removal is kept if fewer crossings remain, or sometimes as many.
class CrossingReduction {
 public:
  CrossingReduction(Recovery& recovery, VertexIndex a, VertexIndex b, unsigned depth, std::size_t& work_left)
      : recovery_(recovery),
        mesh_(recovery.mesh),
        remover_(recovery.mesh, recovery.constraints, &work_left),
        work_left_(work_left),
        a_(a),
        b_(b),
        depth_(depth) {}

  bool run() {
    const std::size_t mark = mesh_.mark();
    unsigned sideways = recovery_budget.sideways_flips;
    while (walk_line(mesh_, a_, b_, line_)) {
      if (step(false)) continue;
      if (sideways == 0 || !step(true)) break;
      --sideways;
    }
    if (mesh_.find_edge(a_, b_) != no_cell) {
      mesh_.keep();
      return true;
    }
    mesh_.roll_back(mark);
    return false;
  }

 private:
  bool step(bool sideways) {
    const std::vector<Crossing> crossings = line_.crossings;
    for (std::size_t k = 0; k < crossings.size() && work_left_ > 0; ++k) {
      // An attempt that was rolled back may have renumbered slots, so the crossings are found anew.
      if ((!walk_line(mesh_, a_, b_, line_) || line_.crossings.size() != crossings.size())) return false;
      const std::size_t mark = mesh_.mark();
      if (remove_crossed(recovery_, remover_, line_.crossings[k], depth_) && is_progress(crossings.size(), sideways)) {
        mesh_.keep();
        return true;
      }
      mesh_.roll_back(mark);
    }
    return false;
  }
  bool is_progress(std::size_t before, bool sideways) {
    if (mesh_.find_edge(a_, b_) != no_cell) return true;
    LineCrossings after;
    if (!walk_line(mesh_, a_, b_, after)) return false;
    return after.crossings.size() < before || (sideways && after.crossings.size() == before);
  }

  Recovery& recovery_;
  ConstrainedMesh& mesh_;
  EdgeRemover remover_;
  std::size_t& work_left_;
  VertexIndex a_, b_;
  unsigned depth_;
  LineCrossings line_;
};

}  // namespace

bool recover_segment_by_flips(Recovery& recovery, VertexIndex a, VertexIndex b, unsigned depth,
                              std::size_t& work_left) {
  return recover_from_ends(recovery, a, b, depth, work_left) ||
         (depth > 1 && !recovery.has_ended() && CrossingReduction(recovery, a, b, depth, work_left).run());
}

}  // namespace geomesh::recover
