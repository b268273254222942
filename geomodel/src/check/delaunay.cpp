// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the Delaunay property. A mesh that is locally Delaunay across every free face is Delaunay as far as vertices
// see each other: along the way from inside a tetrahedron to a vertex that it sees, the power of that vertex falls from
// cell to cell (Shewchuk 2008, "General-dimensional constrained Delaunay and constrained regular triangulations", the
// Delaunay lemma; ties allowed). So it suffices to check the faces.
#include <algorithm>

#include "check/exact/exact.hpp"
#include "check/mesh/checked_mesh.hpp"
#include "check/mesh/faults.hpp"

namespace geomesh::geomodel::checking {
namespace {

VertexIndex apex(const Tetrahedron& cell, const Triangle& face) {
  for (const VertexIndex v : cell)
    if (std::find(face.begin(), face.end(), v) == face.end()) return v;
  return cell[0];
}

}  // namespace

void check_delaunay(const CheckedMesh& mesh, const FacesFile* faces, CheckResult& result) {
  if (!mesh.sound) {
    result.checks_done.emplace_back("Delaunay was not checked, for the faults above");
    return;
  }
  std::vector<Triangle> constrained;
  if (faces) {
    const std::vector<VertexIndex> rows = match_points(mesh, faces->points);
    for (const Triangle& t : faces->triangles) constrained.push_back(sorted({rows[t[0]], rows[t[1]], rows[t[2]]}));
    std::sort(constrained.begin(), constrained.end());
  }
  FaultCollector free_face("not_delaunay"), on_surface("not_delaunay_across_surfaces");
  for (const FacePair& face : mesh.faces) {
    if (!is_inner(face)) continue;
    const Tetrahedron& cell = mesh.cells[face.even];
    const VertexIndex other = apex(mesh.cells[face.odd], face.key);
    if (in_sphere(mesh.point(cell[0]), mesh.point(cell[1]), mesh.point(cell[2]), mesh.point(cell[3]),
                  mesh.point(other)) != Sign::positive)
      continue;
    const bool is_constrained = std::binary_search(constrained.begin(), constrained.end(), face.key);
    (is_constrained ? on_surface : free_face).add(mesh.file.cell[face.even], centroid(mesh, face.key));
  }
  free_face.report(result,
                   "free faces are not Delaunay: the vertex across lies strictly inside the circumsphere (exact)");
  on_surface.report(
      result,
      "faces of surfaces inside the mesh are not Delaunay: the vertex across lies strictly inside the circumsphere");
  result.checks_done.emplace_back(
      "no vertex lies strictly inside the circumsphere of a tetrahedron that sees it (exact, ties allowed)");
}

}  // namespace geomesh::geomodel::checking
