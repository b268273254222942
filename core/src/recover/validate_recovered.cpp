// SPDX-License-Identifier: MIT
#include "recover/recover.hpp"

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
  for (const Subsegment& s : recovery.constraints.subsegments)
    if (s.live) GEOMESH_CHECK(mesh.find_edge(s.a, s.b) != no_cell);
  for (const Subfacet& f : recovery.constraints.subfacets) {
    if (!f.live) continue;
    const FaceRef face = mesh.find_face(f.vertices[0], f.vertices[1], f.vertices[2]);
    GEOMESH_CHECK(face.valid() && mesh.is_locked(face));
  }
}

}  // namespace geomesh::recover
