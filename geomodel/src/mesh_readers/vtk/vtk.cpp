// SPDX-License-Identifier: GPL-3.0-or-later
// Reads meshes from VTK files, declared in mesh_readers/mesh_files.hpp.
#include <array>
#include <cmath>

#include "mesh_readers/mesh_files.hpp"
#include "mesh_readers/vtk/vtk_arrays.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// "porosity (cells, double)".
void list_arrays(const VtkTable& table, const char* where, std::vector<std::string>& names) {
  for (const VtkColumn& column : table.columns) {
    if (column.name.empty()) continue;
    const std::size_t n = column.n_components;
    names.push_back(column.name + " (" + where + ", " + name_of(column.type) +
                    (n > 1 ? " x " + std::to_string(n) : "") + ")");
  }
}

bool is_solid(std::uint8_t type) {
  return (type > vtk_cell::quad && type != vtk_cell::quadratic_edge && type != vtk_cell::quadratic_triangle &&
          type != vtk_cell::quadratic_quad);
}

bool is_value(const VtkColumn& column) { return !column.is_text() && !column.name.empty() && column.n_components == 1; }

void take_cell_values(const VtkData& grid, MeshFile& mesh) {
  for (const VtkColumn& column : grid.cell_data.columns) {
    if (!is_value(column) || mesh.region_array == column.name) continue;
    std::vector<double>& values = mesh.cell_values[column.name];
    for (const std::size_t cell : mesh.cell) values.push_back(column.number(cell));
  }
}

void take_point_values(const VtkData& grid, MeshFile& mesh) {
  for (const VtkColumn& column : grid.point_data.columns) {
    if (!is_value(column)) continue;
    std::vector<double> values = column.numbers();
    values.resize(grid.points.size());
    mesh.point_values[column.name] = std::move(values);
  }
}

void take_groups(const VtkTable& field, MeshFile& mesh, const std::filesystem::path& path) {
  const std::string prefix = "group:";
  for (const VtkColumn& column : field.columns)
    if (!column.is_text() && column.name.starts_with(prefix))
      mesh.region_groups[column.name.substr(prefix.size())] = integers_of(column);
  const std::vector<std::string> names = texts_of(field, "group_names");
  const auto lists = lists_of(field, "group_offsets", "group_region_ids", path);
  for (std::size_t i = 0; i < names.size() && i < lists.size(); ++i) mesh.region_groups[names[i]] = lists[i];
}

/// Cells of a VTK file that are kept besides its volume cells: numbers of its triangles and of its edges.
struct LowerCells {
  std::vector<std::size_t> triangles, edges;
};

/// Reads one cell of a VTK file that is not a tetrahedron: a triangle, an edge or a prism.
void take_other(const VtkData& grid, std::size_t cell, MeshFile& mesh, LowerCells& lower) {
  const std::uint8_t type = grid.cells.types[cell];
  const auto p = grid.cells.of(cell);
  ++(is_solid(type) ? mesh.n_other_solids : mesh.n_lower_cells);
  if (type == vtk_cell::triangle || type == vtk_cell::quadratic_triangle) {
    mesh.triangles.push_back({p[0], p[1], p[2]});
    lower.triangles.push_back(cell);
  } else if (type == vtk_cell::line || type == vtk_cell::quadratic_edge) {
    mesh.edges.push_back({p[0], p[1]});
    lower.edges.push_back(cell);
  } else if (type == vtk_cell::wedge) {
    mesh.prisms.push_back({p[0], p[1], p[2], p[3], p[4], p[5]});
  }
}

LowerCells take_cells(const VtkData& grid, MeshFile& mesh) {
  LowerCells lower;
  for (std::size_t cell = 0; cell < grid.cells.size(); ++cell) {
    const std::uint8_t type = grid.cells.types[cell];
    if (type != vtk_cell::tetrahedron && type != vtk_cell::quadratic_tetrahedron) {
      take_other(grid, cell, mesh, lower);
      continue;
    }
    const auto p = grid.cells.of(cell);
    mesh.tetrahedra.push_back({p[0], p[1], p[2], p[3]});
    mesh.midpoints.insert(mesh.midpoints.end(), p.begin() + 4, p.end());
    mesh.cell.push_back(cell);
  }
  if (mesh.midpoints.size() != 6 * mesh.tetrahedra.size()) mesh.midpoints.clear();
  return lower;
}

void take_ids(const VtkData& grid, const LowerCells& lower, MeshFile& mesh) {
  for (const char* name :
       {"region", "RegionId", "region_id", "MaterialIDs", "attribute", "gmsh:physical", "medit:ref"}) {
    const VtkColumn* const column = grid.cell_data.numbers(name);
    if (!column) continue;
    const auto all = integers_of(*column);
    mesh.region_array = name;
    for (const std::size_t cell : mesh.cell) mesh.region.push_back(all[cell]);
    for (const std::size_t cell : lower.triangles) mesh.triangle_id.push_back(all[cell]);
    for (const std::size_t cell : lower.edges) mesh.edge_id.push_back(all[cell]);
    break;
  }
  if (mesh.region_array == "MaterialIDs" && !names_of(grid.field_data, "region").empty())
    // OpenGeoSys numbers regions from 0; the ids of region names begin with 1.
    for (std::int32_t& id : mesh.region) ++id;
}

void take_point_data(const VtkData& grid, MeshFile& mesh) {
  for (const char* name : {"kind", "input_vertex"})
    if (!grid.point_data.numbers(name)) mesh.missing_arrays.emplace_back(name);
  mesh.input_vertex = integers_of(grid.point_data, "input_vertex");
  mesh.kind = integers_of(grid.point_data, "kind");
  if (const VtkColumn* const ids = grid.point_data.numbers("GlobalPointIds"); ids && ids->n_components == 1)
    for (const std::int64_t id : ids->whole_numbers()) mesh.global_points.push_back(id < 0 ? -1 : id);
  if (const VtkColumn* const before = grid.point_data.numbers("before_zones"); before && before->n_components == 3)
    for (std::size_t i = 0; i < grid.points.size(); ++i)
      mesh.before_zones.push_back({before->number(i, 0), before->number(i, 1), before->number(i, 2)});
  take_point_values(grid, mesh);
}

MeshFile take_grid(VtkData grid, const std::filesystem::path& path) {
  MeshFile mesh;
  mesh.format = "VTK unstructured grid";
  const LowerCells lower = take_cells(grid, mesh);
  list_arrays(grid.point_data, "points", mesh.arrays);
  list_arrays(grid.cell_data, "cells", mesh.arrays);
  take_ids(grid, lower, mesh);
  mesh.surface_names = names_of(grid.field_data, "surface");
  mesh.curve_names = names_of(grid.field_data, "curve");
  mesh.region_names = names_of(grid.field_data, "region");
  if (const VtkColumn* const origin = grid.field_data.numbers("origin");
      origin && origin->n_tuples * origin->n_components == 3)
    mesh.origin = {origin->number(0), origin->number(1), origin->number(2)};
  take_point_data(grid, mesh);
  take_cell_values(grid, mesh);
  take_groups(grid.field_data, mesh, path);
  mesh.single_precision = grid.single_precision;
  mesh.points = std::move(grid.points);
  return mesh;
}

}  // namespace

MeshFile read_vtk_mesh(const std::filesystem::path& path) {
  return take_grid(read_vtk_file(path, VtkData::Kind::grid), path);
}

}  // namespace geomesh::geomodel::checking
