// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "geomesh/geomodel/formats.hpp"

namespace geomesh::python {
namespace {

using geomodel::ModelMesh;

double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

void measure_regions(ModelMesh& mesh) {
  std::vector<long double> volumes(mesh.regions.size(), 0);
  std::vector<std::size_t> counts(mesh.regions.size(), 0);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
    const Tetrahedron& v = mesh.tetrahedra[t];
    const Vec3& a = mesh.points[v[0]];
    const auto region = static_cast<std::size_t>(mesh.tet_region[t] - 1);
    volumes[region] += dot(cross(mesh.points[v[1]] - a, mesh.points[v[2]] - a), mesh.points[v[3]] - a) / 6;
    ++counts[region];
  }
  for (std::size_t r = 0; r < mesh.regions.size(); ++r) {
    mesh.regions[r].volume = static_cast<double>(volumes[r]);
    mesh.regions[r].n_tetrahedra = counts[r];
    if (mesh.regions[r].unit.empty()) mesh.regions[r].unit = mesh.regions[r].name;
  }
}

/// Sums the areas of surfaces. A face counts for every surface on which it lies.
void measure_surfaces(ModelMesh& mesh) {
  std::map<std::int32_t, double> areas;
  for (const ModelMesh::Face& face : mesh.faces) {
    const Vec3& a = mesh.points[face.vertices[0]];
    const double area = length(cross(mesh.points[face.vertices[1]] - a, mesh.points[face.vertices[2]] - a)) / 2;
    for (const std::int32_t id : mesh.surface_sets[static_cast<std::size_t>(face.surface_set)]) areas[id] += area;
  }
  for (geomodel::NamedSurface& surface : mesh.surfaces) surface.area = areas[surface.id];
}

void measure_curves(ModelMesh& mesh) {
  std::map<std::int32_t, double> lengths;
  for (const ModelMesh::CurveEdge& edge : mesh.curve_edges)
    lengths[edge.curve] += length(mesh.points[edge.b] - mesh.points[edge.a]);
  for (geomodel::NamedCurve& curve : mesh.curves) curve.length = lengths[curve.id];
}

}  // namespace

geomodel::JobResult read_mesh(const std::string& file) {
  geomodel::JobResult result;
  result.mesh = geomodel::read_model_mesh(file);
  measure_regions(result.mesh);
  measure_surfaces(result.mesh);
  measure_curves(result.mesh);
  result.files = {file};
  result.report_json = "{}";
  return result;
}

}  // namespace geomesh::python
