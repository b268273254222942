// SPDX-License-Identifier: MIT
#include "recover/constrained/crossed_cells.hpp"

#include <algorithm>
#include <cmath>

#include "common/sort_unique.hpp"
#include "recover/model/messages.hpp"
#include "recover/model/recovery_budget.hpp"

namespace geomesh::recover {

namespace {

/// Returns the squared distance of p from the line through a and b.
double distance_to_line(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 u = b - a, n = cross(u, p - a);
  return dot(n, n) / dot(u, u);
}

}  // namespace

std::vector<CellIndex> crossed_cells(const ConstrainedMesh& mesh, const Crossing& c) {
  if (c.kind == CrossingKind::face) return {c.cell, mesh.cells().mirror(c.face).cell()};
  EdgeRing ring;
  if (!mesh.ring(c.cell, c.v[0], c.v[1], ring)) return {};
  return ring.cells;
}

std::vector<CellIndex> cells_near_crossing(const ConstrainedMesh& mesh, const CrossingsOnLine& on, std::size_t i,
                                           const Vec3& x) {
  constexpr double near = recovery_budget.near_crossing;
  std::vector<CellIndex> out;
  EdgeRing ring;
  for (std::size_t k = 0; k < on.line.crossings.size(); ++k) {
    if (std::fabs(on.parameters[k] - on.parameters[i]) > near) continue;
    const Crossing& c = on.line.crossings[k];
    const std::vector<CellIndex> cells = crossed_cells(mesh, c);
    out.insert(out.end(), cells.begin(), cells.end());
    if (c.kind != CrossingKind::face) continue;
    for (unsigned e = 0; e < 3; ++e) {
      const VertexIndex v = c.v[e], w = c.v[(e + 1) % 3];
      if (distance_to_line(x, mesh.point(v), mesh.point(w)) < near * near * on.length * on.length &&
          mesh.ring(c.cell, v, w, ring))
        out.insert(out.end(), ring.cells.begin(), ring.cells.end());
    }
  }
  sort_unique(out);
  return out;
}

double clearance(const ConstrainedMesh& mesh, const Crossing& c, const Vec3& x, const Vec3& a, const Vec3& b) {
  double out = std::min(dot(x - a, x - a), dot(x - b, x - b));
  for (VertexIndex v : c.v)
    if (v != no_vertex) out = std::min(out, dot(x - mesh.point(v), x - mesh.point(v)));
  return out;
}

bool ends_at_crossed_segment(Recovery& recovery, Index s, const LineCrossings& line) {
  for (const Crossing& c : line.crossings) {
    if (c.kind != CrossingKind::edge) continue;
    const Index other = recovery.constraints.subsegment_of(c.v[0], c.v[1]);
    if (other == no_index) continue;
    recovery.end(error_of_segments_cross(recovery, s, other));
    return true;
  }
  return false;
}

}  // namespace geomesh::recover
