// SPDX-License-Identifier: MIT
#include "recover/model/presence.hpp"
#include "recover/model/recover.hpp"

namespace geomesh::recover {

void validate_recovered(Recovery& recovery) {
  ConstrainedMesh& mesh = recovery.mesh;
  const TetMesh& cells = mesh.cells();
  for (CellIndex c = 0; c < cells.n_slots(); ++c) {
    if (!cells.is_live(c)) continue;
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef f(c, i);
      GEOMESH_CHECK(cells.mirror(cells.mirror(f)) == f);
      GEOMESH_CHECK(mesh.is_locked(f) == mesh.is_locked(cells.mirror(f)));
    }
    if (!cells.is_ghost(c)) GEOMESH_CHECK(mesh.positive(cells.vertices(c)));
  }
  Constraints& constraints = recovery.constraints;
  for (Index s = 0; s < constraints.subsegments.size(); ++s)
    if (constraints.subsegments[s].live) GEOMESH_CHECK(cell_of_subsegment(mesh, constraints, s) != no_cell);
  for (Index f = 0; f < constraints.subfacets.size(); ++f) {
    if (!constraints.subfacets[f].live) continue;
    const FaceRef face = face_of_subfacet(mesh, constraints, f);
    GEOMESH_CHECK(face.valid() && mesh.is_locked(face));
  }
}

}  // namespace geomesh::recover
