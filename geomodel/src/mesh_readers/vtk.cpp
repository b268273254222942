// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's files of meshes, faces and curves, declared in mesh_readers/mesh_files.hpp.
#include <vtkAbstractArray.h>
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <fstream>
#include <iterator>
#include <limits>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/surface.hpp"
#include "mesh_readers/mesh_files.hpp"
#include "mesh_readers/vtk_legacy_guard.hpp"
#include "readers/vtk/vtk_parse.hpp"
#include "readers/vtk/vtk_xml_guard.hpp"

namespace geomesh::geomodel::checking {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw Error(ErrorKind::invalid_input, path.string() + ": " + why);
}

void require_readable(const std::filesystem::path& path) {
  if (!std::ifstream(path)) throw Error(ErrorKind::usage, path.string() + ": cannot be opened");
}

/// Up to the appended data, which are not text.
std::string text_of(const std::filesystem::path& path) {
  constexpr std::string_view last = "<AppendedData";
  std::ifstream in(path, std::ios::binary);
  std::string text;
  for (char block[1 << 16]; in.read(block, sizeof block) || in.gcount() > 0;) {
    const std::size_t seen = text.size() < last.size() ? 0 : text.size() - last.size();
    text.append(block, static_cast<std::size_t>(in.gcount()));
    if (const std::size_t at = text.find(last, seen); at != std::string::npos) return text.substr(0, at);
  }
  return text;
}

/// Keeps VTK from composing its error messages while alive: it prints them. The one for broken cell data of a file
/// without point data dereferences a null pointer (vtkXMLDataReader::ReadPieceData, up to 9.1 at least). A read that
/// failed leaves no points.
class QuietVtk {
 public:
  QuietVtk() : before_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::SetGlobalWarningDisplay(0); }
  ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(before_); }
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

 private:
  int before_;
};

constexpr const char* sizes_lie = "sizes in it are not those of what follows: it is damaged";

/// A mesh holds points; a model may have no curve, and another tool's mesh no face.
enum class May { not_be_empty, be_empty };

/// Runs the reader; refuses where it left nothing.
template <class Reader>
void update(Reader& reader, const std::filesystem::path& path, May may = May::not_be_empty) {
  const QuietVtk quiet;
  reader.SetFileName(path.string().c_str());
  if (!survives_sizes([&] { reader.Update(); })) refuse(path, sizes_lie);
  const bool failed = reader.GetErrorCode() != 0 || !reader.GetOutput();
  if (failed || (may == May::not_be_empty && reader.GetOutput()->GetNumberOfPoints() == 0))
    refuse(path, "VTK finds no points in it: it is empty, truncated or damaged");
}

template <class Reader>
void read_xml(Reader& reader, const std::filesystem::path& path, May may = May::not_be_empty) {
  require_readable(path);
  if (!reader.CanReadFile(path.string().c_str()))
    refuse(path, "is not a VTK XML file of the kind that its extension says");
  const std::string text = text_of(path), fault = fault_of_vtk_elements(text, std::filesystem::file_size(path));
  if (!fault.empty()) refuse(path, fault);
  const bool says_none = text.find("NumberOfPoints=\"0\"") != std::string::npos;  // a read that failed leaves none too
  update(reader, path, says_none ? may : May::not_be_empty);
}

std::vector<Vec3> points_of(vtkPointSet& data, bool& single_precision) {
  std::vector<Vec3> points(static_cast<std::size_t>(data.GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    double p[3];
    data.GetPoint(static_cast<vtkIdType>(i), p);
    points[i] = {p[0], p[1], p[2]};
  }
  single_precision = data.GetPoints() && data.GetPoints()->GetDataType() == VTK_FLOAT;
  return points;
}

/// What is no 32-bit number (an array of floats may hold anything) becomes the least one, which no id is.
std::int32_t nearest_id(double value) {
  using Limits = std::numeric_limits<std::int32_t>;
  return value > Limits::min() && value <= Limits::max() ? static_cast<std::int32_t>(value) : Limits::min();
}

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

std::vector<std::int32_t> integers_of(vtkDataArray& array) {
  std::vector<std::int32_t> values(static_cast<std::size_t>(array.GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = nearest_id(array.GetComponent(static_cast<vtkIdType>(i), 0));
  return values;
}

std::vector<std::int32_t> integers_of(vtkFieldData& data, const char* name) {
  vtkDataArray* array = data.GetArray(name);
  return array ? integers_of(*array) : std::vector<std::int32_t>{};
}

/// Names by id: the field array `region:chalk` holds the id of the region chalk. Files of geomesh 0.1 have the pair of
/// arrays <what>_ids and <what>_names instead.
std::map<std::int32_t, std::string> names_of(vtkFieldData& field, const std::string& what) {
  std::map<std::int32_t, std::string> names;
  const std::string prefix = what + ":";
  for (int i = 0; i < field.GetNumberOfArrays(); ++i) {
    const char* const name = field.GetArrayName(i);
    vtkDataArray* const array = field.GetArray(i);
    if (!name || !array || std::string_view(name).substr(0, prefix.size()) != prefix) continue;
    for (const std::int32_t id : integers_of(*array)) names.emplace(id, name + prefix.size());
  }
  auto* texts = vtkStringArray::SafeDownCast(field.GetAbstractArray((what + "_names").c_str()));
  const std::vector<std::int32_t> ids = integers_of(field, (what + "_ids").c_str());
  if (texts)
    for (std::size_t i = 0; i < ids.size() && i < static_cast<std::size_t>(texts->GetNumberOfValues()); ++i)
      names.emplace(ids[i], texts->GetValue(static_cast<vtkIdType>(i)));
  return names;
}

/// Points of a cell, refused where the file names a point that it does not hold.
std::vector<VertexIndex> cell_points(vtkCellArray& cells, vtkIdType cell, std::size_t n_points,
                                     const std::filesystem::path& path) {
  vtkIdType n = 0;
  const vtkIdType* ids = nullptr;
  cells.GetCellAtId(cell, n, ids);
  std::vector<VertexIndex> result;
  for (vtkIdType i = 0; i < n; ++i) {
    if (ids[i] < 0 || static_cast<std::size_t>(ids[i]) >= n_points)
      refuse(path, "cell " + std::to_string(cell) + " names point " + std::to_string(ids[i]) + " of " +
                       std::to_string(n_points));
    result.push_back(static_cast<VertexIndex>(ids[i]));
  }
  return result;
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

/// The ids in arrays whose names begin so, in the order of the file.
std::vector<std::int32_t> ids_in_order(vtkFieldData& field, const std::string& prefix) {
  std::vector<std::int32_t> ids;
  for (int i = 0; i < field.GetNumberOfArrays(); ++i) {
    const char* const name = field.GetArrayName(i);
    vtkDataArray* const array = field.GetArray(i);
    if (!name || !array || !std::string_view(name).starts_with(prefix)) continue;
    for (const std::int32_t id : integers_of(*array)) ids.push_back(id);
  }
  return ids;
}

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

std::vector<std::string> texts_of(vtkFieldData& field, const char* name) {
  std::vector<std::string> texts;
  auto* array = vtkStringArray::SafeDownCast(field.GetAbstractArray(name));
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i) texts.push_back(array->GetValue(i));
  return texts;
}

/// Lists one after the other, cut at the offsets.
std::vector<std::vector<std::int32_t>> lists_of(vtkFieldData& field, const char* offsets_name, const char* ids_name,
                                                const std::filesystem::path& path) {
  std::vector<std::vector<std::int32_t>> lists;
  const auto offsets = integers_of(field, offsets_name), ids = integers_of(field, ids_name);
  for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
    if (offsets[i] < 0 || offsets[i + 1] < offsets[i] || static_cast<std::size_t>(offsets[i + 1]) > ids.size())
      refuse(path, std::string(offsets_name) + " and " + ids_name + " do not fit each other");
    lists.emplace_back(ids.begin() + offsets[i], ids.begin() + offsets[i + 1]);
  }
  return lists;
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

FacesFile read_faces_file(const std::filesystem::path& path) {
  vtkNew<vtkXMLPolyDataReader> reader;
  read_xml(*reader, path, May::be_empty);
  vtkPolyData& data = *reader->GetOutput();
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

CurvesFile read_curves_file(const std::filesystem::path& path) {
  CurvesFile curves;
  vtkNew<vtkXMLPolyDataReader> reader;
  read_xml(*reader, path, May::be_empty);
  vtkPolyData& data = *reader->GetOutput();
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

}  // namespace geomesh::geomodel::checking
