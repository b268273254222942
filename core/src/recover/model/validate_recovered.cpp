// SPDX-License-Identifier: MIT
#include "geomesh/core/validate.hpp"
#include "recover/model/presence.hpp"
#include "recover/model/recover.hpp"

namespace geomesh::recover {

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
