// SPDX-License-Identifier: MIT
#include "recover/operations/edge_removal.hpp"

#include <array>

#include "mesh/edge_shell.hpp"

namespace geomesh::recover {

namespace {

using RingShell = EdgeShell<bool, EdgeRemover::max_ring>;

/// Accepts the first triangulation of the ring around an edge with positive cells and without forbidden diagonals.
struct PositiveGoal {
  const ConstrainedMesh& mesh;
  const Constraints& constraints;
  const EdgeRing& ring;
  const EdgeRule* rule;
  VertexIndex ear;

  static constexpr bool edge() { return true; }
  static constexpr bool none() { return false; }
  static constexpr bool is_enough(bool found) { return found; }
  bool allows(std::size_t i, std::size_t j) const {
    const VertexIndex a = ring.ring[i], b = ring.ring[j];
    return a != ear && b != ear && !(rule && rule->forbids(a, b)) && !constraints.skips_added_points(a, b);
  }
  bool value(const RingShell::Span& s, bool left, bool right) const {
    if (!left || !right) return false;
    const VertexIndex a = ring.ring[s.i], b = ring.ring[s.k], c = ring.ring[s.j];
    return mesh.orient(a, b, c, ring.q) == Sign::positive && mesh.orient(a, b, c, ring.p) == Sign::negative;
  }
};

}  // namespace

bool EdgeRemover::remove(VertexIndex p, VertexIndex q, unsigned depth, const EdgeRule* rule, unsigned budget,
                         CellIndex hint) {
  budget_ = budget;
  rule_ = rule;
  if (rings_.size() <= depth) rings_.resize(depth + 1);
  return remove_at(p, q, hint, depth, no_vertex);
}

bool EdgeRemover::is_fixed(const EdgeRing& ring) const {
  for (std::size_t i = 0; i < ring.cells.size(); ++i) {
    const CellIndex c = ring.cells[i];
    if (mesh_.is_locked(FaceRef(c, mesh_.cells().index_of(c, ring.ring[i])))) return true;
  }
  return false;
}

bool EdgeRemover::replace_ring(const EdgeRing& ring, VertexIndex ear) {
  if (ring.ring.size() > max_ring) return false;
  RingShell shell;
  if (!shell.triangulate(ring.ring.size(), PositiveGoal{mesh_, constraints_, ring, rule_, ear})) return false;
  filling_.clear();
  shell.for_each_triangle([&](std::size_t i, std::size_t k, std::size_t j) {
    const VertexIndex a = ring.ring[i], b = ring.ring[k], c = ring.ring[j];
    filling_.push_back({a, b, c, ring.q});
    filling_.push_back({a, c, b, ring.p});
  });
  mesh_.replace(ring.cells, filling_);
  return true;
}

bool EdgeRemover::shrink_ring(const EdgeRing& ring, unsigned depth) {
  const std::size_t n = ring.ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    // u, v and w follow each other in the ring of vertices around edge p-q. A 2-3 flip takes v out of the ring if its
    // new edge u-w pierces triangle p, q, v. If u-w passes p-v or q-v on the outside, removing that edge does.
    const VertexIndex u = ring.ring[(i + n - 1) % n], v = ring.ring[i], w = ring.ring[(i + 1) % n];
    const bool beside_p = mesh_.orient(u, w, v, ring.p) != Sign::positive;
    const bool beside_q = mesh_.orient(u, w, ring.q, v) != Sign::positive;
    if (beside_p && remove_at(ring.p, v, ring.cells[i], depth, ring.q)) return true;
    if (beside_q && remove_at(ring.q, v, ring.cells[i], depth, ring.p)) return true;
  }
  return false;
}

/// Counts one more edge or face that flips try to remove. Returns false if no more are allowed.
bool EdgeRemover::spend() {
  if (!work_left_) return true;
  if (*work_left_ == 0) return false;
  --*work_left_;
  return true;
}

bool EdgeRemover::remove_at(VertexIndex p, VertexIndex q, CellIndex hint, unsigned depth, VertexIndex ear) {
  if (budget_ == 0 || !spend()) return false;
  --budget_;
  if (constraints_.is_subsegment(p, q)) return false;
  const std::size_t mark = mesh_.mark();
  EdgeRing& ring = rings_[depth];
  for (std::size_t round = 0; round < max_ring; ++round) {
    const CellIndex cell = mesh_.find_edge(p, q, hint);
    if (cell == no_cell) {
      mesh_.keep();
      return true;
    }
    if (!mesh_.ring(cell, p, q, ring) || is_fixed(ring)) break;
    if (replace_ring(ring, ear)) {
      mesh_.keep();
      return true;
    }
    if (depth == 0 || ring.ring.size() <= 3 || !shrink_ring(ring, depth - 1)) break;
  }
  mesh_.roll_back(mark);
  return false;
}

bool EdgeRemover::flip_face(FaceRef f) {
  if (!spend()) return false;
  const TetMesh& cells = mesh_.cells();
  const FaceRef g = cells.mirror(f);
  if (mesh_.is_locked(f) || cells.is_ghost(f.cell()) || cells.is_ghost(g.cell())) return false;
  const auto& local = face_vertices[f.face()];
  const auto& v = cells.vertices(f.cell());
  const VertexIndex p = v[local[0]], q = v[local[1]], r = v[local[2]], a = v[f.face()],
                    d = cells.vertex(g.cell(), g.face());
  if (constraints_.skips_added_points(a, d)) return false;
  const std::array<Tetrahedron, 3> flipped{{{p, q, d, a}, {q, r, d, a}, {r, p, d, a}}};
  for (const Tetrahedron& t : flipped)
    if (!mesh_.positive(t)) return false;
  const std::array<CellIndex, 2> old{f.cell(), g.cell()};
  mesh_.replace(old, flipped);
  return true;
}

}  // namespace geomesh::recover
