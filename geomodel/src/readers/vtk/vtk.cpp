// SPDX-License-Identifier: GPL-3.0-or-later
// Reads VTK files as surfaces: PolyData (.vtp, .vtk) with polygons, strips and lines; UnstructuredGrid (.vtu, .vtk)
// with triangles, polygons and lines. Single-precision points are converted to doubles. Volume cells are not surfaces:
// such a file is refused here (`geomesh info` and `check` read it).
#include <cmath>

#include "readers/formats.hpp"
#include "readers/text/text.hpp"
#include "readers/triangles/single_surface.hpp"
#include "readers/vtk_legacy.hpp"
#include "vtk_files/vtk_data.hpp"

namespace geomesh::geomodel {
namespace {

void add_points(const InputFile& file, const VtkData& data, SurfaceBuilder& builder) {
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    const Vec3& p = data.points[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      file.fail("point " + std::to_string(i) + " (counted from 0) has a coordinate that is not finite");
    builder.points().push_back(p);
  }
}

void list_arrays(const VtkTable& table, FileContents& contents) {
  for (const VtkColumn& column : table.columns)
    if (!column.name.empty()) contents.arrays.push_back(column.name);
}

struct CellCounts {
  std::size_t volumes = 0, points = 0;
};

void add_polyline(const VtkData& data, std::size_t cell, const InputFile& file, FileContents& contents) {
  Polyline line{file.path.stem().string() + "__" + std::to_string(contents.polylines.size() + 1), file.shown(), {}};
  for (const VertexIndex v : data.cells.of(cell)) line.points.push_back(data.points[v]);
  contents.polylines.push_back(std::move(line));
}

void add_strip(std::span<const VertexIndex> corners, SurfaceBuilder& builder) {
  for (std::size_t k = 0; k + 2 < corners.size(); ++k) {
    const std::size_t odd = k % 2;
    builder.add_polygon({corners[k], corners[k + 1 + odd], corners[k + 2 - odd]}, 0);
  }
}

void add_cells(const InputFile& file, const VtkData& data, SurfaceBuilder& builder, FileContents& contents,
               CellCounts& counts) {
  for (std::size_t c = 0; c < data.cells.size(); ++c) {
    const auto corners = data.cells.of(c);
    std::vector<std::int64_t> polygon(corners.begin(), corners.end());
    switch (data.cells.types[c]) {
      case vtk_cell::empty:
      case vtk_cell::vertex:
      case vtk_cell::poly_vertex:
        ++counts.points;
        break;
      case vtk_cell::line:
      case vtk_cell::poly_line:
        if (corners.size() < 2)
          file.fail("cell " + std::to_string(c) + " (counted from 0) is a line with fewer than two points");
        add_polyline(data, c, file, contents);
        break;
      case vtk_cell::triangle_strip:
        add_strip(corners, builder);
        break;
      case vtk_cell::pixel:
        std::swap(polygon[2], polygon[3]);
        builder.add_polygon(polygon, 0);
        break;
      case vtk_cell::triangle:
      case vtk_cell::polygon:
      case vtk_cell::quad:
        if (corners.size() < 3)
          file.fail("cell " + std::to_string(c) + " (counted from 0) is a polygon with fewer than three corners");
        builder.add_polygon(polygon, 0);
        break;
      case vtk_cell::tetrahedron:
      case vtk_cell::voxel:
      case vtk_cell::hexahedron:
      case vtk_cell::wedge:
      case vtk_cell::pyramid:
        ++counts.volumes;
        break;
      default:
        file.fail("cell " + std::to_string(c) + " (counted from 0) is of VTK's type " +
                  std::to_string(data.cells.types[c]) + ", which is not read: export linear cells");
    }
  }
}

FileContents contents_of(const InputFile& file, const VtkData& data) {
  if (data.kind == VtkData::Kind::image) file.fail("the VTK file holds neither PolyData nor UnstructuredGrid");
  SurfaceBuilder builder(file);
  FileContents contents;
  CellCounts counts;
  add_points(file, data, builder);
  add_cells(file, data, builder, contents, counts);
  if (builder.empty() && contents.polylines.empty()) {
    file.fail(counts.volumes > 0 ? "it holds volume cells and no triangle: it is a mesh, not a surface"
                                 : "the surface is empty: the file holds no triangle");
  }
  list_arrays(data.point_data, contents);
  list_arrays(data.cell_data, contents);
  contents.format = data.kind == VtkData::Kind::poly ? "VTK PolyData" : "VTK UnstructuredGrid";
  if (counts.volumes > 0) contents.warnings.push_back(std::to_string(counts.volumes) + " volume cells are passed over");
  if (counts.points > 0) contents.notes.push_back(std::to_string(counts.points) + " point cells are passed over");
  note_split_polygons(builder.n_split(), contents);
  if (!builder.empty()) contents.surfaces.push_back(builder.take());
  return contents;
}

}  // namespace

bool is_vtk_xml(const InputFile& file) {
  const std::string_view head = file.text().substr(0, 2048);
  return head.find("<VTKFile") != std::string_view::npos;
}

FileContents read_vtk_xml(const InputFile& file) { return contents_of(file, read_vtk_xml_data(file)); }

FileContents read_vtk_legacy(const InputFile& file) { return contents_of(file, read_vtk_legacy_data(file)); }

}  // namespace geomesh::geomodel
