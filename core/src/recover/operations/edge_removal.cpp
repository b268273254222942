// SPDX-License-Identifier: MIT
#include "recover/operations/edge_removal.hpp"

#include <array>

namespace geomesh::recover {

namespace {

/// Triangulation of the ring polygon i..j by its last triangle (i, split, j); none where no positive one exists.
class RingTriangulation {
 public:
  RingTriangulation(const ConstrainedMesh& mesh, const Constraints& constraints, const EdgeRing& ring,
                    const EdgeRule* rule, VertexIndex ear)
      : mesh_(mesh), constraints_(constraints), ring_(ring), rule_(rule), ear_(ear) {}

  bool solve() {
    const unsigned n = static_cast<unsigned>(ring_.ring.size());
    for (unsigned span = 2; span < n; ++span)
      for (unsigned i = 0; i + span < n; ++i) {
        const unsigned j = i + span;
        split_[i][j] = none;
        const bool is_diagonal = span + 1 < n;
        if (is_diagonal && forbidden(ring_.ring[i], ring_.ring[j])) continue;
        for (unsigned k = i + 1; k < j && split_[i][j] == none; ++k)
          if (solved(i, k) && solved(k, j) && positive(i, k, j)) split_[i][j] = static_cast<std::uint8_t>(k);
      }
    return split_[0][n - 1] != none;
  }
  void tetrahedra(std::vector<Tetrahedron>& out) const {
    collect(0, static_cast<unsigned>(ring_.ring.size()) - 1, out);
  }

 private:
  static constexpr std::uint8_t none = 255;

  bool solved(unsigned i, unsigned j) const { return j == i + 1 || split_[i][j] != none; }
  bool forbidden(VertexIndex a, VertexIndex b) const {
    return a == ear_ || b == ear_ || (rule_ && rule_->forbids(a, b)) || constraints_.skips_added_points(a, b);
  }
  bool positive(unsigned i, unsigned k, unsigned j) const {
    const VertexIndex a = ring_.ring[i], b = ring_.ring[k], c = ring_.ring[j];
    return mesh_.orient(a, b, c, ring_.q) == Sign::positive && mesh_.orient(a, b, c, ring_.p) == Sign::negative;
  }
  void collect(unsigned i, unsigned j, std::vector<Tetrahedron>& out) const {
    if (j == i + 1) return;
    const unsigned k = split_[i][j];
    const VertexIndex a = ring_.ring[i], b = ring_.ring[k], c = ring_.ring[j];
    out.push_back({a, b, c, ring_.q});
    out.push_back({a, c, b, ring_.p});
    collect(i, k, out);
    collect(k, j, out);
  }

  const ConstrainedMesh& mesh_;
  const Constraints& constraints_;
  const EdgeRing& ring_;
  const EdgeRule* rule_;
  VertexIndex ear_;
  std::array<std::array<std::uint8_t, EdgeRemover::max_ring>, EdgeRemover::max_ring> split_;
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
  RingTriangulation triangulation(mesh_, constraints_, ring, rule_, ear);
  if (!triangulation.solve()) return false;
  filling_.clear();
  triangulation.tetrahedra(filling_);
  mesh_.replace(ring.cells, filling_);
  return true;
}

bool EdgeRemover::shrink_ring(const EdgeRing& ring, unsigned depth) {
  const std::size_t n = ring.ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    // v leaves the ring where edge u-w pierces the triangle p, q, v; of the edges at v only one that u-w passes by
    // stands in the way.
    const VertexIndex u = ring.ring[(i + n - 1) % n], v = ring.ring[i], w = ring.ring[(i + 1) % n];
    const bool beside_p = mesh_.orient(u, w, v, ring.p) != Sign::positive;
    const bool beside_q = mesh_.orient(u, w, ring.q, v) != Sign::positive;
    if (beside_p && remove_at(ring.p, v, ring.cells[i], depth, ring.q)) return true;
    if (beside_q && remove_at(ring.q, v, ring.cells[i], depth, ring.p)) return true;
  }
  return false;
}

bool EdgeRemover::remove_at(VertexIndex p, VertexIndex q, CellIndex hint, unsigned depth, VertexIndex ear) {
  if (budget_ == 0) return false;
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
