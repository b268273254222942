// SPDX-License-Identifier: MIT
#include "recover/model/presence.hpp"

#include "geomesh/core/validate.hpp"
#include "recover/model/recover.hpp"

namespace geomesh::recover {

namespace {

bool has_face(const TetMesh& cells, CellIndex c, const Triangle& t) {
  return c < cells.n_slots() && cells.is_live(c) && cells.has_vertex(c, t[0]) && cells.has_vertex(c, t[1]) &&
         cells.has_vertex(c, t[2]);
}

bool is_covered_as_seen(const TetMesh& cells, const FacetPiece& piece) {
  for (std::size_t i = 0; i < piece.seen.size(); ++i)
    if (!has_face(cells, piece.seen_in[i], piece.seen[i])) return false;
  return !piece.seen.empty();
}

}  // namespace

CellIndex cell_of_subsegment(ConstrainedMesh& mesh, Constraints& constraints, Index subsegment) {
  Subsegment& s = constraints.subsegments[subsegment];
  return s.seen_in = mesh.find_edge(s.a, s.b, s.seen_in);
}

FaceRef face_of_subfacet(ConstrainedMesh& mesh, Constraints& constraints, Index subfacet) {
  Subfacet& f = constraints.subfacets[subfacet];
  const auto& [a, b, c] = f.vertices;
  if (has_face(mesh.cells(), f.seen_in, f.vertices)) return mesh.face_in_cell(f.seen_in, a, b, c);
  const Index s = constraints.subsegment_of(a, b);
  const CellIndex start = s == no_index ? mesh.find_edge(a, b) : cell_of_subsegment(mesh, constraints, s);
  const FaceRef face = start == no_cell ? FaceRef{} : mesh.find_face_about(start, a, b, c);
  f.seen_in = face.valid() ? face.cell() : no_cell;
  return face;
}

FacetTrace trace_piece(ConstrainedMesh& mesh, Constraints& constraints, Index subfacet) {
  const FacetPiece& piece = constraints.piece_of(subfacet);
  FacetTrace out;
  if (is_covered_as_seen(mesh.cells(), piece)) {
    out.faces = piece.seen;
    out.cells = piece.seen_in;
    return out;
  }
  out = trace_facet(mesh, FacetSides(mesh, constraints.subfacets[subfacet].vertices, piece.members), piece.border);
  if (out.status == FacetTrace::Status::complete) constraints.remember(subfacet, out.faces, out.cells);
  return out;
}

std::vector<CellIndex> cells_of_subsegments(const TetMesh& cells, const Constraints& constraints) {
  std::vector<CellIndex> out(constraints.subsegments.size(), no_cell);
  for (CellIndex c = 0; c < cells.n_slots(); ++c) {
    if (!cells.is_live(c)) continue;
    for (const auto& e : edge_vertices) {
      const Index s = constraints.subsegment_of(cells.vertex(c, e[0]), cells.vertex(c, e[1]));
      if (s != no_index) out[s] = c;
    }
  }
  return out;
}

void validate_cells(const ConstrainedMesh& mesh) {
  const TetMesh& cells = mesh.cells();
  GEOMESH_CHECK(validate_topology(cells, 1).empty());
  for (CellIndex c = 0; c < cells.n_slots(); ++c) {
    if (!cells.is_live(c)) continue;
    for (unsigned i = 0; i < 4; ++i) GEOMESH_CHECK(mesh.is_locked({c, i}) == mesh.is_locked(cells.mirror({c, i})));
    if (!cells.is_ghost(c)) GEOMESH_CHECK(mesh.positive(cells.vertices(c)));
  }
}

void validate_segments(Recovery& recovery) {
  Constraints& constraints = recovery.constraints;
  for (Index s = 0; s < constraints.subsegments.size(); ++s)
    if (constraints.subsegments[s].live) GEOMESH_CHECK(cell_of_subsegment(recovery.mesh, constraints, s) != no_cell);
}

void validate_recovered(Recovery& recovery) {
  validate_cells(recovery.mesh);
  validate_segments(recovery);
  Constraints& constraints = recovery.constraints;
  for (Index f = 0; f < constraints.subfacets.size(); ++f) {
    if (!constraints.subfacets[f].live) continue;
    const FaceRef face = face_of_subfacet(recovery.mesh, constraints, f);
    GEOMESH_CHECK(face.valid() && recovery.mesh.is_locked(face));
  }
}

}  // namespace geomesh::recover
