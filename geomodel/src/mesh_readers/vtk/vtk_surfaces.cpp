// SPDX-License-Identifier: GPL-3.0-or-later
// Faces and curves in VTK's files, declared in mesh_readers/mesh_files.hpp: of files of their own, or of one grid for
// all cells.
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <array>

#include "geomesh/geomodel/surface.hpp"
#include "mesh_readers/mesh_files.hpp"
#include "mesh_readers/vtk/vtk_arrays.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// `curve:NAME` with `curve_kinds` in the same order, then `point:NAME`.
void take_curve_names(vtkFieldData& field, CurvesFile& curves) {
  constexpr const char* kinds[] = {"intersection", "border", "fault_tip", "well", "curve"};
  const std::map<std::int32_t, std::string> names = names_of(field, "curve"), points = names_of(field, "point");
  const std::vector<std::int32_t> ids = ids_in_order(field, "curve:"), numbers = integers_of(field, "curve_kinds");
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const bool known = i < numbers.size() && numbers[i] >= 0 && numbers[i] < 5;
    curves.curves.push_back({ids[i], names.at(ids[i]), known ? kinds[numbers[i]] : "curve"});
  }
  for (const std::int32_t id : ids_in_order(field, "point:")) curves.curves.push_back({id, points.at(id), "point"});
}

FacesFile take_faces(vtkPolyData& data, const std::filesystem::path& path) {
  FacesFile faces;
  bool single_precision = false;
  faces.points = points_of(data, single_precision);
  for (vtkIdType cell = 0; cell < data.GetPolys()->GetNumberOfCells(); ++cell) {
    const auto p = cell_points(*data.GetPolys(), cell, faces.points.size(), path);
    if (p.size() != 3) refuse(path, "face " + std::to_string(cell) + " is no triangle");
    faces.triangles.push_back({p[0], p[1], p[2]});
  }
  const auto take = [&](const char* name, std::vector<std::int32_t>& values) {
    vtkDataArray* array = data.GetCellData()->GetArray(name);
    if (array && static_cast<std::size_t>(array->GetNumberOfTuples()) == faces.triangles.size()) {
      values = integers_of(*array);
    } else {
      faces.missing_arrays.emplace_back(name);
    }
  };
  take("surface", faces.surface);
  take("surface_set", faces.surface_set);
  take("patch", faces.patch);
  take("region_minus", faces.region_minus);
  take("region_plus", faces.region_plus);
  take("source_triangle", faces.source_triangle);
  vtkFieldData& field = *data.GetFieldData();
  faces.surface_names = names_of(field, "surface");
  faces.surface_sets = lists_of(field, "surface_set_offsets", "surface_set_ids", path);
  faces.surface_set_names = texts_of(field, "surface_set_names");
  faces.region_names = names_of(field, "region");
  const std::vector<std::int32_t> ids = integers_of(field, "surface_ids");
  const std::vector<std::string> kinds = texts_of(field, "surface_kinds");
  for (std::size_t i = 0; i < ids.size() && i < kinds.size(); ++i) faces.surface_kinds[ids[i]] = kinds[i];
  const std::vector<std::int32_t> listed = ids_in_order(field, "surface:");
  const std::vector<std::int32_t> numbers = integers_of(field, "surface_kinds");
  for (std::size_t i = 0; kinds.empty() && i < listed.size() && i < numbers.size(); ++i)
    if (numbers[i] >= 0 && numbers[i] <= static_cast<std::int32_t>(SurfaceKind::box))
      faces.surface_kinds[listed[i]] = to_string(static_cast<SurfaceKind>(numbers[i]));
  if (vtkDataArray* rows = data.GetPointData()->GetArray("mesh_point")) faces.mesh_point = integers_of(*rows);
  return faces;
}

CurvesFile take_curves(vtkPolyData& data, const std::filesystem::path& path) {
  CurvesFile curves;
  bool single_precision = false;
  curves.points = points_of(data, single_precision);
  for (vtkIdType cell = 0; cell < data.GetVerts()->GetNumberOfCells(); ++cell) {
    const auto p = cell_points(*data.GetVerts(), cell, curves.points.size(), path);
    if (p.size() != 1) refuse(path, "vertex cell " + std::to_string(cell) + " is no single point");
    curves.vertices.push_back(p[0]);
  }
  for (vtkIdType cell = 0; cell < data.GetLines()->GetNumberOfCells(); ++cell) {
    const auto p = cell_points(*data.GetLines(), cell, curves.points.size(), path);
    if (p.size() != 2) refuse(path, "line " + std::to_string(cell) + " is no single edge");
    curves.edges.push_back({p[0], p[1]});
  }
  const std::size_t n_vertices = curves.vertices.size();
  if (vtkDataArray* array = data.GetCellData()->GetArray("curve")) {
    const auto ids = integers_of(*array);
    if (ids.size() != n_vertices + curves.edges.size()) refuse(path, "array curve has not one number a cell");
    curves.vertex_curve.assign(ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(n_vertices));
    curves.edge_curve.assign(ids.begin() + static_cast<std::ptrdiff_t>(n_vertices), ids.end());
  } else {
    refuse(path, "has no cell array curve");
  }
  vtkFieldData& field = *data.GetFieldData();
  take_curve_names(field, curves);
  const auto ids = integers_of(field, "curve_ids");
  const auto names = texts_of(field, "curve_names"), kinds = texts_of(field, "curve_kinds");
  for (std::size_t i = 0; i < ids.size() && i < names.size() && i < kinds.size(); ++i)
    curves.curves.push_back({ids[i], names[i], kinds[i]});
  if (vtkDataArray* rows = data.GetPointData()->GetArray("mesh_point")) curves.mesh_point = integers_of(*rows);
  return curves;
}

/// Cells of one dimension of a grid with the grid's points and names, as the file of their own would hold them.
class PartOfGrid {
 public:
  /// `renamed` is the grid's array of ids, which the file calls `id_name`.
  PartOfGrid(vtkUnstructuredGrid& grid, const char* renamed, const char* id_name)
      : grid_(grid), renamed_(renamed), id_name_(id_name) {
    data_->SetPoints(grid.GetPoints());
    data_->SetFieldData(grid.GetFieldData());
    vtkNew<vtkIntArray> rows;
    rows->SetName("mesh_point");
    rows->SetNumberOfTuples(grid.GetNumberOfPoints());
    for (vtkIdType p = 0; p < grid.GetNumberOfPoints(); ++p) rows->SetValue(p, static_cast<int>(p));
    data_->GetPointData()->AddArray(rows);
  }

  /// The cells of either type, by their corners; nodes in the middle of edges are left out.
  vtkNew<vtkCellArray> take(std::array<int, 2> types, vtkIdType n_corners) {
    vtkNew<vtkCellArray> cells;
    for (vtkIdType cell = 0; cell < grid_.GetNumberOfCells(); ++cell) {
      if (std::find(types.begin(), types.end(), grid_.GetCellType(cell)) == types.end()) continue;
      vtkIdType n = 0;
      const vtkIdType* ids = nullptr;
      grid_.GetCells()->GetCellAtId(cell, n, ids);
      if (n < n_corners) continue;
      cells->InsertNextCell(n_corners, ids);
      taken_.push_back(cell);
    }
    return cells;
  }

  vtkPolyData& finish() {
    vtkCellData& from = *grid_.GetCellData();
    for (int i = 0; i < from.GetNumberOfArrays(); ++i) {
      vtkDataArray* const array = from.GetArray(i);
      if (!array || !array->GetName() || array->GetNumberOfTuples() < grid_.GetNumberOfCells()) continue;
      vtkNew<vtkIntArray> values;
      const bool is_id = array->GetName() == renamed_;
      values->SetName(is_id ? id_name_ : array->GetName());
      const int first = is_id && renamed_ == "MaterialIDs" ? 1 : 0;  // OpenGeoSys counts from 0, the names from 1
      const std::vector<std::int32_t> all = integers_of(*array);
      for (const vtkIdType cell : taken_) values->InsertNextValue(all[static_cast<std::size_t>(cell)] + first);
      data_->GetCellData()->AddArray(values);
    }
    return *data_;
  }

  vtkPolyData& data() { return *data_; }

 private:
  vtkUnstructuredGrid& grid_;
  std::string renamed_;
  const char* id_name_;
  vtkNew<vtkPolyData> data_;
  std::vector<vtkIdType> taken_;
};

const char* array_of_ids(vtkUnstructuredGrid& grid) {
  for (const char* name : {"region", "MaterialIDs", "attribute"})
    if (grid.GetCellData()->GetArray(name)) return name;
  return "";
}

}  // namespace

FacesFile read_faces_file(const std::filesystem::path& path) {
  vtkNew<vtkXMLPolyDataReader> reader;
  read_xml(*reader, path, May::be_empty);
  return take_faces(*reader->GetOutput(), path);
}

CurvesFile read_curves_file(const std::filesystem::path& path) {
  vtkNew<vtkXMLPolyDataReader> reader;
  read_xml(*reader, path, May::be_empty);
  return take_curves(*reader->GetOutput(), path);
}

std::optional<SurfacesOfGrid> read_surfaces_of_grid(const std::filesystem::path& path) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  read_xml(*reader, path);
  vtkUnstructuredGrid& grid = *reader->GetOutput();
  if (!grid.GetCellData()->GetArray("surface_set")) return std::nullopt;
  if (grid.GetCells() && !grid.GetCells()->IsValid())
    refuse(path, "has offsets of cells that do not fit their connectivity (damaged)");
  const char* const ids = array_of_ids(grid);
  SurfacesOfGrid surfaces;
  PartOfGrid faces(grid, ids, "surface"), curves(grid, ids, "curve");
  faces.data().SetPolys(faces.take({VTK_TRIANGLE, VTK_QUADRATIC_TRIANGLE}, 3));
  surfaces.faces = take_faces(faces.finish(), path);
  curves.data().SetVerts(curves.take({VTK_VERTEX, VTK_VERTEX}, 1));
  curves.data().SetLines(curves.take({VTK_LINE, VTK_QUADRATIC_EDGE}, 2));
  surfaces.curves = take_curves(curves.finish(), path);
  return surfaces;
}

}  // namespace geomesh::geomodel::checking
