// SPDX-License-Identifier: MIT
#include "geomesh/core/validate.hpp"
#include "recover/model/presence.hpp"
#include "recover/model/recover.hpp"

namespace geomesh::recover {

void validate_recovered(Recovery& recovery) {
  ConstrainedMesh& mesh = recovery.mesh;
  const TetMesh& cells = mesh.cells();
  GEOMESH_CHECK(validate_topology(cells, 1).empty());
  GEOMESH_CHECK(validate_geometry(cells, mesh.points(), 1).empty());
  for (CellIndex c = 0; c < cells.n_slots(); ++c)
    for (unsigned i = 0; i < 4 && cells.is_live(c); ++i)
      GEOMESH_CHECK(mesh.is_locked({c, i}) == mesh.is_locked(cells.mirror({c, i})));
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
