// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver_mesh/corners/free_corners.hpp"

#include <algorithm>

#include "solver_mesh/corners/divide_tetrahedra.hpp"
#include "solver_mesh/corners/shape_values.hpp"

namespace geomesh::geomodel {

namespace {

/// Returns for each point of the mesh whether it is a corner of a face on this surface with tetrahedra on both sides.
std::vector<bool> points_on(const ModelMesh& mesh, std::int32_t surface) {
  std::vector<bool> is_on(mesh.points.size(), false);
  for (const auto& face : mesh.faces) {
    if (face.region_minus == 0 || face.region_plus == 0) continue;
    const auto& members = mesh.surface_sets[static_cast<std::size_t>(face.surface_set)];
    if (std::find(members.begin(), members.end(), surface) == members.end()) continue;
    for (const VertexIndex v : face.vertices) is_on[v] = true;
  }
  return is_on;
}

Vec3 mean_of(const std::vector<Vec3>& points, const Tetrahedron& t) {
  return 0.25 * ((points[t[0]] + points[t[1]]) + (points[t[2]] + points[t[3]]));
}

VertexIndex add_centre(ModelMesh& mesh, const Tetrahedron& t) {
  mesh.points.push_back(
      centre_that_divides(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]));
  mesh.point_kind.push_back(4);  // inside
  mesh.input_vertex.push_back(-1);
  if (!mesh.before_zones.empty()) mesh.before_zones.push_back(mean_of(mesh.before_zones, t));
  for (PointArray& array : mesh.point_arrays) {
    double sum = 0;
    for (const VertexIndex v : t) sum += array.values[v];
    array.values.push_back(sum / 4);
  }
  return static_cast<VertexIndex>(mesh.points.size() - 1);
}

/// Stores one of the four tetrahedra into which a tetrahedron is divided. The first one replaces the divided
/// tetrahedron in `row`; the others are appended.
void put_part(ModelMesh& mesh, std::size_t row, const Tetrahedron& part, bool is_first) {
  const std::size_t at = is_first ? row : mesh.tetrahedra.size();
  if (!is_first) {
    mesh.tetrahedra.emplace_back();
    mesh.tet_region.push_back(mesh.tet_region[row]);
    for (CellArray& array : mesh.cell_arrays) array.values.push_back(array.values[row]);
  }
  mesh.tetrahedra[at] = part;
  const TetrahedronShape shape =
      tetrahedron_shape(mesh.points[part[0]], mesh.points[part[1]], mesh.points[part[2]], mesh.points[part[3]]);
  for (CellArray& array : mesh.cell_arrays)
    if (const auto value = shape_value(array.name, shape)) array.values[at] = *value;
}

void divide(ModelMesh& mesh, std::size_t row) {
  const Tetrahedron t = mesh.tetrahedra[row];
  const VertexIndex centre = add_centre(mesh, t);
  for (std::size_t i = 0; i < 4; ++i) {
    Tetrahedron part = t;
    part[i] = centre;
    put_part(mesh, row, part, i == 0);
  }
  mesh.regions[static_cast<std::size_t>(mesh.tet_region[row] - 1)].n_tetrahedra += 3;
}

}  // namespace

std::vector<std::size_t> tetrahedra_on_surfaces(const ModelMesh& mesh, const std::vector<std::string>& surfaces) {
  std::vector<std::size_t> rows;
  for (const NamedSurface& surface : mesh.surfaces) {
    if (std::find(surfaces.begin(), surfaces.end(), surface.name) == surfaces.end()) continue;
    const std::vector<bool> is_on = points_on(mesh, surface.id);
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
      if (std::ranges::all_of(mesh.tetrahedra[t], [&](VertexIndex v) { return is_on[v]; })) rows.push_back(t);
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

ModelMesh with_free_corners(const ModelMesh& mesh, const std::vector<std::string>& surfaces) {
  ModelMesh freed = mesh;
  for (const std::size_t row : tetrahedra_on_surfaces(mesh, surfaces)) divide(freed, row);
  return freed;
}

}  // namespace geomesh::geomodel
