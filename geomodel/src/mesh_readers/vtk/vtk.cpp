// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's files of meshes, declared in mesh_readers/mesh_files.hpp.
#include <vtkAbstractArray.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <fstream>
#include <iterator>

#include "mesh_readers/mesh_files.hpp"
#include "mesh_readers/vtk/vtk_arrays.hpp"
#include "mesh_readers/vtk/vtk_legacy_guard.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// What is no whole number that a double can hold becomes -1, which no row is.
std::int64_t nearest_number(double value) {
  constexpr double most = 9007199254740992;
  return value >= 0 && value < most ? static_cast<std::int64_t>(value) : -1;
}

/// "porosity (cells, double)".
void list_arrays(vtkFieldData& data, const char* where, std::vector<std::string>& names) {
  for (int i = 0; i < data.GetNumberOfArrays(); ++i) {
    vtkAbstractArray* array = data.GetAbstractArray(i);
    if (!array || !array->GetName()) continue;
    const int n = array->GetNumberOfComponents();
    names.push_back(std::string(array->GetName()) + " (" + where + ", " + array->GetDataTypeAsString() +
                    (n > 1 ? " x " + std::to_string(n) : "") + ")");
  }
}

bool is_solid(int type) {
  switch (type) {
    case VTK_EMPTY_CELL:
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
    case VTK_LINE:
    case VTK_POLY_LINE:
    case VTK_TRIANGLE:
    case VTK_TRIANGLE_STRIP:
    case VTK_POLYGON:
    case VTK_PIXEL:
    case VTK_QUAD:
    case VTK_QUADRATIC_EDGE:
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_QUADRATIC_QUAD:
      return false;
    default:
      return true;
  }
}

/// Arrays of one number a cell, of the tetrahedra alone.
void take_cell_values(vtkUnstructuredGrid& grid, MeshFile& mesh) {
  for (int i = 0; i < grid.GetCellData()->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = grid.GetCellData()->GetArray(i);
    if (!array || !array->GetName() || array->GetNumberOfComponents() != 1 ||
        array->GetNumberOfTuples() < grid.GetNumberOfCells() || mesh.region_array == array->GetName())
      continue;
    std::vector<double>& values = mesh.cell_values[array->GetName()];
    for (const std::size_t cell : mesh.cell) values.push_back(array->GetComponent(static_cast<vtkIdType>(cell), 0));
  }
}

/// Point arrays of one number.
void take_point_values(vtkUnstructuredGrid& grid, MeshFile& mesh) {
  for (int i = 0; i < grid.GetPointData()->GetNumberOfArrays(); ++i) {
    vtkDataArray* array = grid.GetPointData()->GetArray(i);
    if (!array || !array->GetName() || array->GetNumberOfComponents() != 1 ||
        array->GetNumberOfTuples() < grid.GetNumberOfPoints())
      continue;
    std::vector<double>& values = mesh.point_values[array->GetName()];
    for (vtkIdType p = 0; p < grid.GetNumberOfPoints(); ++p) values.push_back(array->GetComponent(p, 0));
  }
}

void take_groups(vtkFieldData& field, MeshFile& mesh, const std::filesystem::path& path) {
  const std::string prefix = "group:";
  for (int i = 0; i < field.GetNumberOfArrays(); ++i) {
    const char* const name = field.GetArrayName(i);
    vtkDataArray* const array = field.GetArray(i);
    if (name && array && std::string_view(name).starts_with(prefix))
      mesh.region_groups[name + prefix.size()] = integers_of(*array);
  }
  const std::vector<std::string> names = texts_of(field, "group_names");
  const auto lists = lists_of(field, "group_offsets", "group_region_ids", path);
  for (std::size_t i = 0; i < names.size() && i < lists.size(); ++i) mesh.region_groups[names[i]] = lists[i];
}

/// Numbers of the cells that are kept although they are no solids.
struct LowerCells {
  std::vector<std::size_t> triangles, edges;
};

void take_lower(vtkUnstructuredGrid& grid, vtkIdType cell, const std::filesystem::path& path, MeshFile& mesh,
                LowerCells& lower) {
  const int type = grid.GetCellType(cell);
  if (type != VTK_TRIANGLE && type != VTK_QUADRATIC_TRIANGLE && type != VTK_LINE && type != VTK_QUADRATIC_EDGE) return;
  const auto p = cell_points(*grid.GetCells(), cell, mesh.points.size(), path);
  if ((type == VTK_TRIANGLE || type == VTK_QUADRATIC_TRIANGLE) && p.size() >= 3) {
    mesh.triangles.push_back({p[0], p[1], p[2]});
    lower.triangles.push_back(static_cast<std::size_t>(cell));
  } else if (p.size() >= 2) {
    mesh.edges.push_back({p[0], p[1]});
    lower.edges.push_back(static_cast<std::size_t>(cell));
  }
}

void take_prism(vtkUnstructuredGrid& grid, vtkIdType cell, const std::filesystem::path& path, MeshFile& mesh) {
  if (grid.GetCellType(cell) != VTK_WEDGE) return;
  const auto p = cell_points(*grid.GetCells(), cell, mesh.points.size(), path);
  if (p.size() == 6) mesh.prisms.push_back({p[0], p[1], p[2], p[3], p[4], p[5]});
}

MeshFile take_grid(vtkUnstructuredGrid& grid, const std::filesystem::path& path) {
  MeshFile mesh;
  mesh.format = "VTK unstructured grid";
  mesh.points = points_of(grid, mesh.single_precision);
  if (mesh.points.size() >= no_vertex) refuse(path, "holds more points than 32 bits can count");
  if (grid.GetCells() && !grid.GetCells()->IsValid())
    refuse(path, "has offsets of cells that do not fit their connectivity (damaged)");
  LowerCells lower;
  for (vtkIdType cell = 0; cell < grid.GetNumberOfCells(); ++cell) {
    const int type = grid.GetCellType(cell);
    if (type == VTK_TETRA || type == VTK_QUADRATIC_TETRA) {
      const auto p = cell_points(*grid.GetCells(), cell, mesh.points.size(), path);
      if (p.size() != (type == VTK_TETRA ? 4u : 10u))
        refuse(path, "cell " + std::to_string(cell) + " is called a tetrahedron and has " + std::to_string(p.size()) +
                         " points");
      mesh.tetrahedra.push_back({p[0], p[1], p[2], p[3]});
      mesh.midpoints.insert(mesh.midpoints.end(), p.begin() + 4, p.end());
      mesh.cell.push_back(static_cast<std::size_t>(cell));
    } else {
      ++(is_solid(type) ? mesh.n_other_solids : mesh.n_lower_cells);
      take_lower(grid, cell, path, mesh, lower);
      take_prism(grid, cell, path, mesh);
    }
  }
  if (mesh.midpoints.size() != 6 * mesh.tetrahedra.size()) mesh.midpoints.clear();
  list_arrays(*grid.GetPointData(), "points", mesh.arrays);
  list_arrays(*grid.GetCellData(), "cells", mesh.arrays);
  for (const char* name :
       {"region", "RegionId", "region_id", "MaterialIDs", "attribute", "gmsh:physical", "medit:ref"}) {
    vtkDataArray* array = grid.GetCellData()->GetArray(name);
    if (!array) continue;
    const auto all = integers_of(*array);
    if (all.size() < static_cast<std::size_t>(grid.GetNumberOfCells()))
      refuse(path, "has fewer numbers in the cell array " + std::string(name) + " than cells (damaged)");
    mesh.region_array = name;
    for (const std::size_t cell : mesh.cell) mesh.region.push_back(all[cell]);
    for (const std::size_t cell : lower.triangles) mesh.triangle_id.push_back(all[cell]);
    for (const std::size_t cell : lower.edges) mesh.edge_id.push_back(all[cell]);
    break;
  }
  if (mesh.region_array == "MaterialIDs" && !names_of(*grid.GetFieldData(), "region").empty())
    for (std::int32_t& id : mesh.region) ++id;  // OpenGeoSys counts from 0, the names from 1
  mesh.surface_names = names_of(*grid.GetFieldData(), "surface");
  mesh.curve_names = names_of(*grid.GetFieldData(), "curve");
  mesh.region_names = names_of(*grid.GetFieldData(), "region");
  for (const char* name : {"kind", "input_vertex"})
    if (!grid.GetPointData()->GetArray(name)) mesh.missing_arrays.emplace_back(name);
  if (vtkDataArray* rows = grid.GetPointData()->GetArray("input_vertex")) mesh.input_vertex = integers_of(*rows);
  if (vtkDataArray* kinds = grid.GetPointData()->GetArray("kind")) mesh.kind = integers_of(*kinds);
  if (vtkDataArray* ids = grid.GetPointData()->GetArray("GlobalPointIds"))
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
      mesh.global_points.push_back(nearest_number(ids->GetComponent(i, 0)));
  if (vtkDataArray* before = grid.GetPointData()->GetArray("before_zones");
      before && before->GetNumberOfComponents() == 3)
    for (vtkIdType i = 0; i < before->GetNumberOfTuples(); ++i)
      mesh.before_zones.push_back({before->GetComponent(i, 0), before->GetComponent(i, 1), before->GetComponent(i, 2)});
  if (vtkDataArray* origin = grid.GetFieldData()->GetArray("origin"); origin && origin->GetNumberOfValues() == 3)
    mesh.origin = {origin->GetVariantValue(0).ToDouble(), origin->GetVariantValue(1).ToDouble(),
                   origin->GetVariantValue(2).ToDouble()};
  take_cell_values(grid, mesh);
  take_point_values(grid, mesh);
  take_groups(*grid.GetFieldData(), mesh, path);
  return mesh;
}

}  // namespace

MeshFile read_vtk_mesh(const std::filesystem::path& path) {
  if (path.extension() == ".vtu") {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    read_xml(*reader, path);
    return take_grid(*reader->GetOutput(), path);
  }
  require_readable(path);
  std::ifstream in(path, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (const std::string fault = fault_of_legacy_cells(content); !fault.empty()) refuse(path, fault);
  vtkNew<vtkUnstructuredGridReader> reader;
  const VtkMessages messages;  // it sets no error code, and leaves what it could not read as memory was
  reader->SetFileName(path.string().c_str());
  if (!survives_sizes([&] { reader->Update(); })) refuse(path, sizes_lie);
  if (const std::string reason = messages.first_reason(); !reason.empty())
    refuse(path, "VTK cannot read it: " + reason);
  if (!reader->GetOutput() || reader->GetOutput()->GetNumberOfPoints() == 0)
    refuse(path, "VTK finds no points in it: it is empty, truncated or damaged");
  return take_grid(*reader->GetOutput(), path);
}

}  // namespace geomesh::geomodel::checking
