// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that points of the faces and curves files equal those of the mesh, declared in check/arrays/check_arrays.hpp.
#include "check/arrays/check_arrays.hpp"
#include "check/mesh/faults.hpp"

namespace geomesh::geomodel::checking {

void check_mesh_points(const CheckedMesh& mesh, const std::vector<Vec3>& points, const std::vector<std::int32_t>& rows,
                       const std::string& file, CheckResult& result) {
  FaultCollector wrong("wrong_mesh_points");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool right = i < rows.size() && rows[i] >= 0 && static_cast<std::size_t>(rows[i]) < mesh.n_points() &&
                       mesh.point(static_cast<VertexIndex>(rows[i])) == points[i];
    if (!right) wrong.add(i, points[i]);
  }
  wrong.report(result, "points of " + file + " have a mesh_point that is not the mesh's point at their place, or none");
}

}  // namespace geomesh::geomodel::checking
