// SPDX-License-Identifier: MIT
/// Segments by flips alone: what the line from one end crosses first is removed, from either end in turn (after the boundary recovery of
/// George and Borouchaki 1998 and of Si 2015; own design on the n-to-m removal of edge_removal.hpp).
#include "recover/crossing.hpp"
#include "recover/messages.hpp"
#include "recover/recover.hpp"

namespace geomesh::recover {

namespace {

/// Removes the simplex crossed, or a neighbour that stands in the way of its removal.
bool remove_crossed(Recovery& recovery, EdgeRemover& remover, const Crossing& crossing, VertexIndex a, unsigned depth) {
  ConstrainedMesh& mesh = recovery.mesh;
  if (crossing.kind == CrossingKind::edge) return remover.remove(crossing.v[0], crossing.v[1], depth);
  if (remover.flip_face(crossing.face)) return true;
  const FaceRef beyond = mesh.cells().mirror(crossing.face);
  const VertexIndex d = mesh.cells().vertex(beyond.cell(), beyond.face());
  const auto v = crossing.v;  // counter-clockwise seen from a
  for (unsigned k = 0; k < 3; ++k) {
    const VertexIndex p = v[k], q = v[(k + 1) % 3];
    if (mesh.orient(p, q, d, a) == Sign::positive) continue;
    if (remover.remove(p, q, depth)) return true;
  }
  return false;
}

}  // namespace

bool recover_segment_by_flips(Recovery& recovery, VertexIndex a, VertexIndex b, unsigned depth) {
  EdgeRemover remover(recovery.mesh, recovery.constraints);
  unsigned failures = 0;
  const unsigned max_flips = 200;
  for (unsigned step = 0; step < max_flips && failures < 2; ++step) {
    const Crossing crossing = first_crossing(recovery.mesh, a, b);
    if (crossing.kind == CrossingKind::edge_present) return true;
    if (crossing.kind == CrossingKind::vertex) {
      fail_vertex_on_segment(recovery, crossing.v[0], recovery.constraints.subsegment_of(a, b));
    }
    if (crossing.kind == CrossingKind::edge) {
      const Index other = recovery.constraints.subsegment_of(crossing.v[0], crossing.v[1]);
      if (other != no_index) fail_segments_cross(recovery, recovery.constraints.subsegment_of(a, b), other);
    }
    if (remove_crossed(recovery, remover, crossing, a, depth)) {
      failures = 0;
    } else {
      ++failures;
      std::swap(a, b);
    }
  }
  return false;
}

}  // namespace geomesh::recover
