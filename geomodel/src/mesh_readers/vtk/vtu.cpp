// SPDX-License-Identifier: GPL-3.0-or-later
// Reads VTU files of any tool: regions from the cell array of ids; for files written by geomesh also NAME.faces.vtp and
// NAME.curves.vtp.
#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "mesh_readers/mesh_files.hpp"
#include "mesh_readers/mesh_readers.hpp"
#include "mesh_readers/vtk/vtk_arrays.hpp"

namespace geomesh::geomodel {
namespace {

/// Names of arrays that are not properties: those of a single grid for all cells, and those of parts of a mesh.
constexpr std::array<std::string_view, 8> arrays_of_cells{"surface_set",  "patch",           "region_minus",
                                                          "region_plus",  "source_triangle", "GlobalCellIds",
                                                          "vtkGhostType", "partition"};
constexpr std::array<std::string_view, 4> arrays_of_points{"kind", "input_vertex", "GlobalPointIds", "vtkGhostType"};

void add_sets_by_id(const std::vector<std::int32_t>& ids, int dimension,
                    const std::map<std::int32_t, std::string>& names, RawMesh& mesh) {
  std::map<std::int32_t, RawSet> sets;
  for (std::size_t row = 0; row < ids.size(); ++row) {
    RawSet& set = sets[ids[row]];
    set.rows.push_back(row);
  }
  for (auto& [id, set] : sets) {
    const auto name = names.find(id);
    set.name = name == names.end() ? "" : name->second;
    set.id = id;
    set.dimension = dimension;
    mesh.sets.push_back(std::move(set));
  }
}

void add_faces(const checking::FacesFile& file, const std::vector<VertexIndex>& row, RawMesh& mesh) {
  std::map<std::int32_t, RawSet> sets;
  for (const auto& [id, name] : file.surface_names) sets[id] = {name, id, 2, {}};
  for (std::size_t f = 0; f < file.triangles.size(); ++f) {
    for (const VertexIndex v : file.triangles[f]) mesh.cells[2].corners.push_back(row[v]);
    const bool listed = f < file.surface_set.size() && file.surface_set[f] >= 0 &&
                        static_cast<std::size_t>(file.surface_set[f]) < file.surface_sets.size();
    if (listed) {
      for (const std::int32_t id : file.surface_sets[static_cast<std::size_t>(file.surface_set[f])])
        sets[id].rows.push_back(f);
    } else if (f < file.surface.size()) {
      sets[file.surface[f]].rows.push_back(f);
    }
  }
  for (auto& [id, set] : sets) {
    set.id = id;
    set.dimension = 2;
    if (!set.rows.empty()) mesh.sets.push_back(std::move(set));
  }
}

/// Returns the row in the mesh of each point of a file of faces or curves beside it. Returns nothing if the file has no
/// such rows, as files of other programs. Throws Error{invalid_input} if a point differs from that of the mesh.
std::optional<std::vector<VertexIndex>> indices_in_mesh(const std::vector<Vec3>& points,
                                                        const std::vector<std::int32_t>& numbers, const RawMesh& mesh,
                                                        const std::filesystem::path& file) {
  if (numbers.size() != points.size()) return std::nullopt;
  std::vector<VertexIndex> indices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto at = static_cast<std::size_t>(numbers[i]);
    if (numbers[i] < 0 || at >= mesh.points.size() || mesh.points[at] != points[i])
      checking::refuse(file, "its point " + std::to_string(i) +
                                 " is not a point of the mesh beside it, so the files are not of one run; write them "
                                 "anew, or move this file away to read the mesh without it");
    indices.push_back(static_cast<VertexIndex>(at));
  }
  return indices;
}

}  // namespace

RawMesh read_vtu_mesh(const std::filesystem::path& path) {
  checking::MeshFile file =
      path.extension() == ".pvtu" ? checking::read_pvtu_mesh(path) : checking::read_vtk_mesh(path);
  RawMesh mesh;
  mesh.format = "VTU";
  mesh.points = std::move(file.points);
  mesh.n_other_solids = file.n_other_solids;
  mesh.origin = file.origin;
  mesh.numbers = std::move(file.cell);
  for (const Tetrahedron& t : file.tetrahedra)
    mesh.cells[3].corners.insert(mesh.cells[3].corners.end(), t.begin(), t.end());
  mesh.midpoints = std::move(file.midpoints);
  mesh.second_order = !mesh.midpoints.empty();
  add_sets_by_id(file.region, 3, file.region_names, mesh);
  for (auto& [name, values] : file.cell_values)
    if (std::find(arrays_of_cells.begin(), arrays_of_cells.end(), name) == arrays_of_cells.end())
      mesh.cell_arrays.push_back({name, std::move(values)});
  for (auto& [name, values] : file.point_values)
    if (std::find(arrays_of_points.begin(), arrays_of_points.end(), name) == arrays_of_points.end() &&
        !name.starts_with("nodes:"))
      mesh.point_arrays.push_back({name, std::move(values)});
  mesh.before_zones = std::move(file.before_zones);
  mesh.point_kind = std::move(file.kind);
  mesh.input_vertex = std::move(file.input_vertex);
  const std::filesystem::path stem = path.parent_path() / path.stem();
  if (const std::filesystem::path faces = stem.string() + ".faces.vtp"; std::filesystem::exists(faces)) {
    const checking::FacesFile set = checking::read_faces_file(faces);
    if (const auto indices = indices_in_mesh(set.points, set.mesh_point, mesh, faces)) add_faces(set, *indices, mesh);
  } else {
    for (const auto& triangle : file.triangles)
      mesh.cells[2].corners.insert(mesh.cells[2].corners.end(), triangle.begin(), triangle.end());
    add_sets_by_id(file.triangle_id, 2, file.surface_names, mesh);
    for (const auto& edge : file.edges)
      mesh.cells[1].corners.insert(mesh.cells[1].corners.end(), edge.begin(), edge.end());
    add_sets_by_id(file.edge_id, 1, file.curve_names, mesh);
  }
  if (const std::filesystem::path curves = stem.string() + ".curves.vtp"; std::filesystem::exists(curves)) {
    const checking::CurvesFile set = checking::read_curves_file(curves);
    if (const auto indices = indices_in_mesh(set.points, set.mesh_point, mesh, curves)) {
      for (const auto& edge : set.edges)
        for (const VertexIndex v : edge) mesh.cells[1].corners.push_back((*indices)[v]);
      std::map<std::int32_t, std::string> names;
      for (const auto& curve : set.curves) names[curve.id] = curve.name;
      add_sets_by_id(set.edge_curve, 1, names, mesh);
      for (const VertexIndex v : set.vertices) mesh.cells[0].corners.push_back((*indices)[v]);
      add_sets_by_id(set.vertex_curve, 0, names, mesh);
    }
  }
  return mesh;
}

}  // namespace geomesh::geomodel
