// SPDX-License-Identifier: MIT
#include "recover/model/crossing.hpp"

#include <algorithm>

#include "recover/model/recovery_budget.hpp"

namespace geomesh::recover {

namespace {

/// Returns which simplex of the face of cell c opposite a the ray from a to b crosses, if b is in the cell's cone at a.
bool crossing_in_cell(const ConstrainedMesh& mesh, CellIndex c, VertexIndex a, VertexIndex b, Crossing& out) {
  const TetMesh& cells = mesh.cells();
  const unsigned i = cells.index_of(c, a);
  const auto& v = cells.vertices(c);
  const auto& local = face_vertices[i];
  std::array<Sign, 3> side;  // side[k]: side of the cell's face opposite vertex local[k] on which vertex b lies
  for (unsigned k = 0; k < 3; ++k) {
    side[k] = mesh.orient(a, v[local[(k + 1) % 3]], v[local[(k + 2) % 3]], b);
    if (side[k] == Sign::positive) return false;
  }
  out.cell = c;
  out.face = FaceRef(c, i);
  unsigned n = 0;
  for (unsigned k = 0; k < 3; ++k)
    if (side[k] == Sign::negative) out.v[n++] = v[local[k]];
  out.kind = n == 1 ? CrossingKind::vertex : n == 2 ? CrossingKind::edge : CrossingKind::face;
  return n > 0;
}

}  // namespace

Crossing first_crossing(ConstrainedMesh& mesh, VertexIndex a, VertexIndex b) {
  Crossing out;
  const TetMesh& cells = mesh.cells();
  CellIndex c = mesh.cell_of(a);
  Random random = walk_choices(a, b);
  for (unsigned step = 0; step < recovery_budget.star_walk && !cells.is_ghost(c); ++step) {
    if (cells.has_vertex(c, b)) {
      out.cell = c;
      return out;
    }
    if (crossing_in_cell(mesh, c, a, b, out)) return out;
    const unsigned exit = mesh.exit_towards(c, a, b, random);
    if (exit == 4) break;
    c = cells.neighbor_cell(c, exit);
  }
  std::vector<CellIndex> star;
  mesh.star(a, star);
  for (CellIndex s : star)
    if (cells.has_vertex(s, b)) {
      out.cell = s;
      return out;
    }
  for (CellIndex s : star)
    if (!cells.is_ghost(s) && crossing_in_cell(mesh, s, a, b, out)) return out;
  GEOMESH_CHECK(!"the star of a vertex covers all directions");
  return out;
}

namespace {

/// Follows the line from a to b from one crossed simplex to the next. All signs are exact.
class LineWalk {
 public:
  LineWalk(ConstrainedMesh& mesh, VertexIndex a, VertexIndex b, LineCrossings& out)
      : mesh_(mesh), a_(a), b_(b), out_(out) {}

  bool run() {
    Crossing at = first_crossing(mesh_, a_, b_);
    if (at.kind == CrossingKind::edge_present) return false;
    add(at.cell);
    for (std::size_t step = 0; step < recovery_budget.line_walk; ++step) {
      if (at.kind == CrossingKind::vertex) return false;
      out_.crossings.push_back(at);
      const bool ok = at.kind == CrossingKind::face ? leave_face(at) : leave_edge(at);
      if (!ok) return false;
      if (at.kind == CrossingKind::edge_present) return true;
    }
    return false;
  }

 private:
  int side(VertexIndex v, VertexIndex w) const { return static_cast<int>(mesh_.orient(a_, b_, v, w)); }
  void add(CellIndex c) {
    if (std::find(out_.cells.begin(), out_.cells.end(), c) == out_.cells.end()) out_.cells.push_back(c);
  }
  void cross_face(Crossing& at, CellIndex c, unsigned face) const {
    at.kind = CrossingKind::face;
    at.cell = c;
    at.face = FaceRef(c, face);
    for (unsigned k = 0; k < 3; ++k) at.v[k] = mesh_.cells().vertex(c, face_vertices[face][k]);
  }
  static void cross_edge(Crossing& at, CellIndex c, VertexIndex v, VertexIndex w) {
    at.kind = CrossingKind::edge;
    at.cell = c;
    at.v = {v, w, no_vertex};
  }

  bool leave_face(Crossing& at) {
    const TetMesh& cells = mesh_.cells();
    const FaceRef entry = cells.mirror(at.face);
    const CellIndex c = entry.cell();
    if (cells.is_ghost(c)) return false;
    add(c);
    const VertexIndex d = cells.vertex(c, entry.face());
    if (d == b_) {
      at.kind = CrossingKind::edge_present;
      return true;
    }
    std::array<VertexIndex, 3> v = at.v;
    const int s = side(v[0], v[1]);
    std::array<int, 3> z;
    for (unsigned k = 0; k < 3; ++k) z[k] = s * side(v[k], d);
    for (unsigned k = 0; k < 3; ++k) {
      const unsigned n = (k + 1) % 3;
      if (z[k] < 0 && z[n] > 0) {
        cross_face(at, c, cells.index_of(c, v[(k + 2) % 3]));
        return true;
      }
    }
    for (unsigned k = 0; k < 3; ++k)
      if (z[k] == 0 && z[(k + 1) % 3] > 0 && z[(k + 2) % 3] < 0) {
        cross_edge(at, c, v[k], d);
        return true;
      }
    return false;  // the line runs through the vertex d opposite the face that it crossed
  }

  bool leave_edge(Crossing& at) {
    const VertexIndex p = at.v[0], q = at.v[1];
    EdgeRing ring;
    if (!mesh_.ring(at.cell, p, q, ring)) return false;
    for (CellIndex c : ring.cells) add(c);
    const std::size_t n = ring.ring.size();
    if (std::find(ring.ring.begin(), ring.ring.end(), b_) != ring.ring.end()) {
      at.kind = CrossingKind::edge_present;
      return true;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const VertexIndex u = ring.ring[i], w = ring.ring[(i + 1) % n];
      const int after_u = static_cast<int>(mesh_.orient(p, q, u, b_)),
                before_w = static_cast<int>(mesh_.orient(p, q, b_, w));
      if (after_u < 0 || before_w <= 0) continue;
      return after_u == 0 ? leave_in_plane(at, ring.cells[i], p, q, u, w) : leave_wedge(at, ring.cells[i], p, q, u, w);
    }
    return false;
  }
  /// Follows the line, which crosses edge p-q and then runs in the plane of face p,q,u, to its crossing of p-u or q-u.
  bool leave_in_plane(Crossing& at, CellIndex c, VertexIndex p, VertexIndex q, VertexIndex u, VertexIndex w) const {
    const int sp = static_cast<int>(mesh_.orient(a_, b_, w, p)), su = static_cast<int>(mesh_.orient(a_, b_, w, u));
    if (su == 0) return false;
    cross_edge(at, c, su == sp ? q : p, u);
    return true;
  }
  bool leave_wedge(Crossing& at, CellIndex c, VertexIndex p, VertexIndex q, VertexIndex u, VertexIndex w) const {
    const int s = side(u, w);
    if (s == 0) {
      cross_edge(at, c, u, w);
      return true;
    }
    const int wp = side(w, p), pu = side(p, u);
    if (wp == 0 || pu == 0) return false;
    const bool on_p_side = wp == s && pu == s;
    cross_face(at, c, mesh_.cells().index_of(c, on_p_side ? q : p));
    return true;
  }

  ConstrainedMesh& mesh_;
  VertexIndex a_, b_;
  LineCrossings& out_;
};

}  // namespace

bool walk_line(ConstrainedMesh& mesh, VertexIndex a, VertexIndex b, LineCrossings& out) {
  out.crossings.clear();
  out.cells.clear();
  return LineWalk(mesh, a, b, out).run();
}

}  // namespace geomesh::recover
