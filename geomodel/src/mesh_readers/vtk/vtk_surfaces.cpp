// SPDX-License-Identifier: GPL-3.0-or-later
// Reads faces and curves in VTK's files, declared in mesh_readers/mesh_files.hpp: they are in separate files, or in a
// single grid for all cells.
#include <algorithm>
#include <array>
#include <numeric>

#include "geomesh/geomodel/surface.hpp"
#include "mesh_readers/mesh_files.hpp"
#include "mesh_readers/vtk/vtk_arrays.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Rows of the cells in a VTK file, by the kind of cell.
struct CellRows {
  std::vector<std::size_t> vertices, lines, faces;
};
CellRows rows_by_kind(const VtkCells& cells) {
  CellRows rows;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const std::uint8_t type = cells.types[cell];
    if (type == vtk_cell::vertex || type == vtk_cell::poly_vertex) rows.vertices.push_back(cell);
    if (type == vtk_cell::line || type == vtk_cell::poly_line) rows.lines.push_back(cell);
    if (type == vtk_cell::triangle || type == vtk_cell::quad || type == vtk_cell::polygon) rows.faces.push_back(cell);
  }
  return rows;
}

/// Reads the names of curves (field arrays `curve:NAME`, with `curve_kinds` in the same order), then those of points
/// (`point:NAME`).
void take_curve_names(const VtkTable& field, CurvesFile& curves) {
  constexpr const char* kinds[] = {"intersection", "border", "fault_tip", "well", "curve"};
  const std::map<std::int32_t, std::string> names = names_of(field, "curve"), points = names_of(field, "point");
  const std::vector<std::int32_t> ids = ids_in_order(field, "curve:"), numbers = integers_of(field, "curve_kinds");
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const bool known = i < numbers.size() && numbers[i] >= 0 && numbers[i] < 5;
    curves.curves.push_back({ids[i], names.at(ids[i]), known ? kinds[numbers[i]] : "curve"});
  }
  for (const std::int32_t id : ids_in_order(field, "point:")) curves.curves.push_back({id, points.at(id), "point"});
}

FacesFile take_faces(const VtkData& data, const std::filesystem::path& path) {
  FacesFile faces;
  faces.points = data.points;
  for (const std::size_t cell : rows_by_kind(data.cells).faces) {
    const auto p = data.cells.of(cell);
    if (p.size() != 3) refuse(path, "face " + std::to_string(faces.triangles.size()) + " is no triangle");
    faces.triangles.push_back({p[0], p[1], p[2]});
  }
  const auto take = [&](const char* name, std::vector<std::int32_t>& values) {
    const VtkColumn* const column = data.cell_data.numbers(name);
    if (column && column->n_tuples == faces.triangles.size())
      values = integers_of(*column);
    else
      faces.missing_arrays.emplace_back(name);
  };
  take("surface", faces.surface);
  take("surface_set", faces.surface_set);
  take("patch", faces.patch);
  take("region_minus", faces.region_minus);
  take("region_plus", faces.region_plus);
  take("source_triangle", faces.source_triangle);
  const VtkTable& field = data.field_data;
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
  faces.mesh_point = integers_of(data.point_data, "mesh_point");
  return faces;
}

CurvesFile take_curves(const VtkData& data, const std::filesystem::path& path) {
  CurvesFile curves;
  curves.points = data.points;
  const CellRows rows = rows_by_kind(data.cells);
  for (const std::size_t cell : rows.vertices) {
    const auto p = data.cells.of(cell);
    if (p.size() != 1) refuse(path, "vertex cell " + std::to_string(cell) + " is no single point");
    curves.vertices.push_back(p[0]);
  }
  for (const std::size_t cell : rows.lines) {
    const auto p = data.cells.of(cell);
    if (p.size() != 2) refuse(path, "line " + std::to_string(curves.edges.size()) + " is no single edge");
    curves.edges.push_back({p[0], p[1]});
  }
  const VtkColumn* const column = data.cell_data.numbers("curve");
  if (!column) refuse(path, "has no cell array curve");
  const auto all = integers_of(*column);
  if (all.size() != curves.vertices.size() + curves.edges.size()) refuse(path, "array curve has not one number a cell");
  for (const std::size_t cell : rows.vertices) curves.vertex_curve.push_back(all[cell]);
  for (const std::size_t cell : rows.lines) curves.edge_curve.push_back(all[cell]);
  const VtkTable& field = data.field_data;
  take_curve_names(field, curves);
  const auto ids = integers_of(field, "curve_ids");
  const auto names = texts_of(field, "curve_names"), kinds = texts_of(field, "curve_kinds");
  for (std::size_t i = 0; i < ids.size() && i < names.size() && i < kinds.size(); ++i)
    curves.curves.push_back({ids[i], names[i], kinds[i]});
  curves.mesh_point = integers_of(data.point_data, "mesh_point");
  return curves;
}

/// Extracts the cells of one dimension from a single grid (a VTU file with cells of all dimensions). The result has the
/// points and names of the grid, and the form of a separate file of faces or curves.
class PartOfGrid {
 public:
  /// Prepares to extract the cells of one dimension from `grid`. The array with the ids of their surfaces or curves is
  /// called `renamed` in the grid, and `id_name` in the result.
  PartOfGrid(const VtkData& grid, const char* renamed, const char* id_name)
      : grid_(grid), renamed_(renamed), id_name_(id_name) {
    data_.kind = VtkData::Kind::poly;
    data_.points = grid.points;
    data_.field_data = grid.field_data;
    std::vector<std::int32_t> rows(grid.points.size());
    std::iota(rows.begin(), rows.end(), 0);
    data_.point_data.put(column_of("mesh_point", rows));
  }

  /// Adds the cells of two VTK types (first and second order) by their corners; midpoint nodes are left out.
  void take(std::array<std::uint8_t, 2> types, std::size_t n_corners) {
    for (std::size_t cell = 0; cell < grid_.cells.size(); ++cell) {
      if (std::find(types.begin(), types.end(), grid_.cells.types[cell]) == types.end()) continue;
      const auto corners = grid_.cells.of(cell).first(n_corners);
      data_.cells.corners.insert(data_.cells.corners.end(), corners.begin(), corners.end());
      data_.cells.first.push_back(data_.cells.corners.size());
      data_.cells.types.push_back(types[0]);
      taken_.push_back(cell);
    }
  }

  const VtkData& finish() {
    for (const VtkColumn& column : grid_.cell_data.columns) {
      if (column.is_text() || column.name.empty()) continue;
      const bool is_id = column.name == renamed_;
      // OpenGeoSys numbers regions from 0; the ids of region names begin with 1
      const int first = is_id && renamed_ == "MaterialIDs" ? 1 : 0;
      const std::vector<std::int32_t> all = integers_of(column);
      std::vector<std::int32_t> values;
      for (const std::size_t cell : taken_) values.push_back(all[cell] + first);
      data_.cell_data.put(column_of(is_id ? id_name_ : column.name, values));
    }
    return data_;
  }

 private:
  static VtkColumn column_of(const std::string& name, const std::vector<std::int32_t>& values) {
    const auto bytes = std::as_bytes(std::span(values));
    return {name, VtkType::int32, 1, values.size(), {bytes.begin(), bytes.end()}, {}};
  }

  const VtkData& grid_;
  std::string renamed_, id_name_;
  VtkData data_;
  std::vector<std::size_t> taken_;
};

const char* array_of_ids(const VtkData& grid) {
  for (const char* name : {"region", "MaterialIDs", "attribute"})
    if (grid.cell_data.numbers(name)) return name;
  return "";
}

}  // namespace

FacesFile read_faces_file(const std::filesystem::path& path) {
  return take_faces(read_vtk_file(path, VtkData::Kind::poly, May::be_empty), path);
}

CurvesFile read_curves_file(const std::filesystem::path& path) {
  return take_curves(read_vtk_file(path, VtkData::Kind::poly, May::be_empty), path);
}

std::optional<SurfacesOfGrid> read_surfaces_of_grid(const std::filesystem::path& path) {
  const VtkData grid = read_vtk_file(path, VtkData::Kind::grid);
  if (!grid.cell_data.numbers("surface_set")) return std::nullopt;
  const char* const ids = array_of_ids(grid);
  SurfacesOfGrid surfaces;
  PartOfGrid faces(grid, ids, "surface"), curves(grid, ids, "curve");
  faces.take({vtk_cell::triangle, vtk_cell::quadratic_triangle}, 3);
  surfaces.faces = take_faces(faces.finish(), path);
  curves.take({vtk_cell::vertex, vtk_cell::vertex}, 1);
  curves.take({vtk_cell::line, vtk_cell::quadratic_edge}, 2);
  surfaces.curves = take_curves(curves.finish(), path);
  return surfaces;
}

}  // namespace geomesh::geomodel::checking
