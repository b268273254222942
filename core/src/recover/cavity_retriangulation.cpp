// SPDX-License-Identifier: MIT
#include "recover/cavity_retriangulation.hpp"

#include <algorithm>
#include <set>

#include "recover/crossing.hpp"

namespace geomesh::recover {

namespace {

using Edge = std::array<VertexIndex, 2>;
Edge edge_key(VertexIndex a, VertexIndex b) { return a < b ? Edge{a, b} : Edge{b, a}; }

std::set<Edge> boundary_edges(const Cavity& cavity) {
  std::set<Edge> out;
  for (const Triangle& t : cavity.boundary)
    for (unsigned i = 0; i < 3; ++i) out.insert(edge_key(t[i], t[(i + 1) % 3]));
  return out;
}

bool fill_with_sheet(Recovery& recovery, const Cavity& cavity, const Triangle& sheet, std::size_t max_nodes) {
  std::vector<Triangle> boundary = cavity.boundary;
  boundary.push_back(sheet);
  boundary.push_back({sheet[0], sheet[2], sheet[1]});
  const auto filling = fill_polyhedron(recovery.mesh, recovery.constraints, boundary, {90, max_nodes});
  if (!filling) return false;
  recovery.mesh.replace(cavity.cells, *filling);
  return true;
}

}  // namespace

std::optional<Cavity> make_cavity(const Recovery& recovery, std::vector<CellIndex> cells) {
  const ConstrainedMesh& mesh = recovery.mesh;
  Cavity out;
  std::sort(cells.begin(), cells.end());
  out.cells = std::move(cells);
  for (CellIndex c : out.cells) {
    if (mesh.cells().is_ghost(c)) return std::nullopt;
    for (unsigned i = 0; i < 4; ++i) {
      if (std::binary_search(out.cells.begin(), out.cells.end(), mesh.cells().neighbor_cell(c, i))) {
        if (mesh.is_locked(FaceRef(c, i))) return std::nullopt;
        continue;
      }
      const auto& l = face_vertices[i];
      out.boundary.push_back({mesh.cells().vertex(c, l[0]), mesh.cells().vertex(c, l[1]), mesh.cells().vertex(c, l[2])});
    }
  }
  const std::set<Edge> kept = boundary_edges(out);
  std::set<VertexIndex> vertices;
  for (const Edge& e : kept) vertices.insert(e.begin(), e.end());
  for (CellIndex c : out.cells)
    for (const auto& e : edge_vertices) {
      const VertexIndex a = mesh.cells().vertex(c, e[0]), b = mesh.cells().vertex(c, e[1]);
      if (!vertices.count(a) || !vertices.count(b)) return std::nullopt;
      if (!kept.count(edge_key(a, b)) && recovery.constraints.is_subsegment(a, b)) return std::nullopt;
    }
  return out;
}

bool recover_segment_by_cavity(Recovery& recovery, VertexIndex a, VertexIndex b, std::size_t max_nodes) {
  LineCrossings line;
  if (!walk_line(recovery.mesh, a, b, line)) return false;
  const auto cavity = make_cavity(recovery, std::move(line.cells));
  if (!cavity) return false;
  const std::set<Edge> edges = boundary_edges(*cavity);
  std::vector<VertexIndex> apexes;
  const Index s = recovery.constraints.subsegment_of(a, b);
  if (s != no_index)
    for (Index f : recovery.constraints.subsegments[s].subfacets)
      for (VertexIndex v : recovery.constraints.subfacets[f].vertices)
        if (v != a && v != b) apexes.push_back(v);
  for (const Edge& e : edges)
    if (e[0] == a || e[1] == a) apexes.push_back(e[0] == a ? e[1] : e[0]);
  std::set<VertexIndex> tried;
  for (VertexIndex c : apexes) {
    if (!tried.insert(c).second || !edges.count(edge_key(a, c)) || !edges.count(edge_key(b, c))) continue;
    if (fill_with_sheet(recovery, *cavity, {a, b, c}, max_nodes)) return true;
  }
  return false;
}

bool recover_face_by_cavity(Recovery& recovery, const Triangle& t, std::vector<CellIndex> pierced, std::size_t max_nodes) {
  const auto cavity = make_cavity(recovery, std::move(pierced));
  return cavity && fill_with_sheet(recovery, *cavity, t, max_nodes);
}

}  // namespace geomesh::recover
