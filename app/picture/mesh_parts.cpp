// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_parts.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkPlane.h>
#include <vtkTableBasedClipDataSet.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <tuple>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/quality.hpp"

namespace geomesh::picture {
namespace {

/// Returns names by id: the field array `region:chalk` contains the id of the region chalk.
std::map<int, std::string> names_in(vtkFieldData* field, const std::string& prefix) {
  std::map<int, std::string> by_id;
  for (int i = 0; i < field->GetNumberOfArrays(); ++i) {
    const char* const name = field->GetArrayName(i);
    auto* const ids = field->GetArray(i);
    if (!name || !ids || std::string(name).rfind(prefix, 0) != 0) continue;
    for (vtkIdType k = 0; k < ids->GetNumberOfTuples(); ++k)
      by_id[static_cast<int>(ids->GetTuple1(k))] = name + prefix.size();
  }
  return by_id;
}

Vec3 point_of(const MeshFile& mesh, vtkIdType v) {
  std::array<double, 3> p{};
  mesh.cells->GetPoint(v, p.data());
  return {p[0], p[1], p[2]};
}

/// Returns the corners of a cell of the mesh in the order in which the file lists them.
std::array<vtkIdType, 4> corners(const MeshFile& mesh, vtkIdType cell) {
  auto ids = vtkSmartPointer<vtkIdList>::New();
  mesh.cells->GetCellPoints(cell, ids);
  return {ids->GetId(0), ids->GetId(1), ids->GetId(2), ids->GetId(3)};
}

/// A face by its corners, and the cell that has it.
struct CellFace {
  std::array<vtkIdType, 3> sorted, as_seen;
  vtkIdType cell;
};

std::vector<CellFace> faces_of(const MeshFile& mesh, const std::function<bool(vtkIdType)>& wanted) {
  constexpr std::array<std::array<int, 3>, 4> sides{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  std::vector<CellFace> faces;
  for (vtkIdType c = 0; c < mesh.cells->GetNumberOfCells(); ++c) {
    if (mesh.cells->GetCellType(c) != VTK_TETRA || !wanted(c)) continue;
    const auto v = corners(mesh, c);
    for (const auto& side : sides) {
      CellFace face{{v[side[0]], v[side[1]], v[side[2]]}, {v[side[0]], v[side[1]], v[side[2]]}, c};
      std::sort(face.sorted.begin(), face.sorted.end());
      faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end(), [](const CellFace& a, const CellFace& b) {
    return std::tie(a.sorted, a.cell) < std::tie(b.sorted, b.cell);
  });
  return faces;
}

vtkSmartPointer<vtkPolyData> triangles(vtkPoints* points, const std::vector<std::array<vtkIdType, 3>>& rows,
                                       const std::vector<double>& values) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName("value");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    cells->InsertNextCell(3, rows[i].data());
    array->InsertNextValue(values[i]);
  }
  data->SetPolys(cells);
  data->GetCellData()->SetScalars(array);
  return data;
}

bool is_side(const std::string& name) {
  static const std::array<const char*, 6> box{"xmin", "xmax", "ymin", "ymax", "zmin", "zmax"};
  return std::find(box.begin(), box.end(), name) != box.end() || name.rfind("side_", 0) == 0;
}

}  // namespace

MeshFile read_mesh_file(const std::filesystem::path& file) {
  MeshFile mesh;
  auto reader = vtkSmartPointer<vtkXMLUnstructuredGridReader>::New();
  reader->SetFileName(file.c_str());
  reader->Update();
  mesh.cells = reader->GetOutput();
  if (!mesh.cells || mesh.cells->GetNumberOfCells() == 0)
    throw std::runtime_error(file.string() + " holds no tetrahedra; a .vtu of geomesh was expected");
  mesh.region_names = names_in(mesh.cells->GetFieldData(), "region:");
  auto* const regions = mesh.cells->GetCellData()->GetArray("region");
  for (vtkIdType c = 0; c < mesh.cells->GetNumberOfCells(); ++c)
    mesh.region_of_cell.push_back(regions ? static_cast<int>(regions->GetTuple1(c)) : 0);
  std::ifstream report(file.parent_path() / (file.stem().string() + ".report.json"));
  mesh.colours = geomodel::colours_of_report(
      std::string(std::istreambuf_iterator<char>(report), std::istreambuf_iterator<char>()));
  const std::filesystem::path faces = file.parent_path() / (file.stem().string() + ".faces.vtp");
  if (!std::filesystem::exists(faces)) return mesh;
  auto face_reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
  face_reader->SetFileName(faces.c_str());
  face_reader->Update();
  mesh.faces = face_reader->GetOutput();
  mesh.surface_names = names_in(mesh.faces->GetFieldData(), "surface:");
  return mesh;
}

vtkSmartPointer<vtkPolyData> outside_of(const MeshFile& mesh, const std::function<bool(vtkIdType)>& wanted,
                                        const std::function<double(vtkIdType)>& value_of) {
  const std::vector<CellFace> faces = faces_of(mesh, wanted);
  std::vector<std::array<vtkIdType, 3>> rows;
  std::vector<double> values;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const bool again = (i > 0 && faces[i - 1].sorted == faces[i].sorted) ||
                       (i + 1 < faces.size() && faces[i + 1].sorted == faces[i].sorted);
    if (again) continue;  // a face that two visible cells share is not drawn
    rows.push_back(faces[i].as_seen);
    values.push_back(value_of(faces[i].cell));
  }
  return triangles(mesh.cells->GetPoints(), rows, values);
}

vtkSmartPointer<vtkUnstructuredGrid> with_region_values(const MeshFile& mesh) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->ShallowCopy(mesh.cells);
  auto value = vtkSmartPointer<vtkDoubleArray>::New();
  value->SetName("value");
  for (const int region : mesh.region_of_cell) value->InsertNextValue(region);
  grid->GetCellData()->SetScalars(value);
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> beyond(vtkUnstructuredGrid* grid, const HalfSpace& half) {
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(half.origin[0], half.origin[1], 0);
  plane->SetNormal(half.normal[0], half.normal[1], 0);
  auto clip = vtkSmartPointer<vtkTableBasedClipDataSet>::New();
  clip->SetInputData(grid);
  clip->SetClipFunction(plane);
  clip->Update();
  return clip->GetOutput();
}

vtkSmartPointer<vtkPolyData> outside_of(vtkUnstructuredGrid* grid) {
  auto outside = vtkSmartPointer<vtkDataSetSurfaceFilter>::New();
  outside->SetInputData(grid);
  outside->Update();
  return outside->GetOutput();
}

void centre_of(const MeshFile& mesh, vtkIdType cell, double centre[3]) {
  const auto v = corners(mesh, cell);
  Vec3 sum;
  for (const vtkIdType corner : v) sum = sum + point_of(mesh, corner);
  for (int k = 0; k < 3; ++k) centre[k] = sum[static_cast<std::size_t>(k)] / 4;
}

double smallest_dihedral(const MeshFile& mesh, vtkIdType cell) {
  const auto v = corners(mesh, cell);
  return tetrahedron_shape(point_of(mesh, v[0]), point_of(mesh, v[1]), point_of(mesh, v[2]), point_of(mesh, v[3]))
      .min_dihedral;
}

vtkSmartPointer<vtkPolyData> inner_surfaces(const MeshFile& mesh) {
  if (!mesh.faces) return nullptr;
  auto* const surfaces = mesh.faces->GetCellData()->GetArray("surface");
  if (!surfaces) return nullptr;
  std::vector<std::array<vtkIdType, 3>> rows;
  std::vector<double> values;
  auto ids = vtkSmartPointer<vtkIdList>::New();
  for (vtkIdType c = 0; c < mesh.faces->GetNumberOfCells(); ++c) {
    const auto name = mesh.surface_names.find(static_cast<int>(surfaces->GetTuple1(c)));
    if (name != mesh.surface_names.end() && is_side(name->second)) continue;
    mesh.faces->GetCellPoints(c, ids);
    if (ids->GetNumberOfIds() != 3) continue;
    rows.push_back({ids->GetId(0), ids->GetId(1), ids->GetId(2)});
    values.push_back(surfaces->GetTuple1(c));
  }
  if (rows.empty()) return nullptr;
  return triangles(mesh.faces->GetPoints(), rows, values);
}

}  // namespace geomesh::picture
