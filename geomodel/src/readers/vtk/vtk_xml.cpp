// SPDX-License-Identifier: GPL-3.0-or-later
// VTK XML: PolyData (.vtp) with polygons, strips and lines; UnstructuredGrid (.vtu) with triangles, polygons and lines.
// Single-precision points are widened. Volume cells are no surface: such a file is refused here (`geomesh info` and
// `check` read it).
#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <limits>

#include "readers/formats.hpp"
#include "readers/text/text.hpp"
#include "readers/triangles/single_surface.hpp"
#include "readers/vtk/vtk_parse.hpp"

namespace geomesh::geomodel {
namespace {

void add_points(const InputFile& file, vtkPointSet& data, SurfaceBuilder& builder) {
  const vtkIdType n = data.GetNumberOfPoints();
  for (vtkIdType i = 0; i < n; ++i) {
    Vec3 p;
    data.GetPoint(i, &p.x);
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      file.fail("point " + std::to_string(i) + " (counted from 0) has a coordinate that is not finite");
    }
    builder.points().push_back(p);
  }
}

void list_arrays(vtkFieldData& data, FileContents& contents) {
  for (int i = 0; i < data.GetNumberOfArrays(); ++i)
    if (const char* name = data.GetArrayName(i)) contents.arrays.emplace_back(name);
}

struct CellCounts {
  std::size_t lines = 0, volumes = 0, points = 0;
};

/// Offsets within the connectivity, connectivity within the points, and cells of at least so many corners: VTK follows
/// all of them without looking.
void require_valid(const InputFile& file, vtkCellArray* cells, vtkIdType n_points, vtkIdType least_corners) {
  if (!cells) return;
  if (!cells->IsValid()) file.fail("the offsets of its cells do not fit their connectivity (damaged)");
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c) {
    cells->GetCellAtId(c, ids);
    if (ids->GetNumberOfIds() < least_corners)
      file.fail("cell " + std::to_string(c) + " (counted from 0, of its kind) has " +
                std::to_string(ids->GetNumberOfIds()) + " corners; at least " + std::to_string(least_corners) +
                " were expected");
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      if (ids->GetId(k) < 0 || ids->GetId(k) >= n_points)
        file.fail("a face names vertex row " + std::to_string(ids->GetId(k)) + " (counted from 0), but there are " +
                  std::to_string(n_points) + " vertices");
  }
}

struct CornerRange {
  vtkIdType least, most;  ///< none fits where most is less
};
CornerRange corners_of_type(int type) {
  constexpr vtkIdType any = std::numeric_limits<vtkIdType>::max();
  switch (type) {
    case VTK_EMPTY_CELL:
      return {0, any};
    case VTK_VERTEX:
      return {1, 1};
    case VTK_POLY_VERTEX:
      return {1, any};
    case VTK_LINE:
      return {2, 2};
    case VTK_POLY_LINE:
      return {2, any};
    case VTK_TRIANGLE:
      return {3, 3};
    case VTK_TRIANGLE_STRIP:
    case VTK_POLYGON:
      return {3, any};
    case VTK_PIXEL:
    case VTK_QUAD:
    case VTK_TETRA:
      return {4, 4};
    case VTK_PYRAMID:
      return {5, 5};
    case VTK_WEDGE:
      return {6, 6};
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
      return {8, 8};
    default:
      return {1, 0};  // curved cells and polyhedra
  }
}

/// As require_valid; and each cell has the corners that its type has, where that is one number.
void require_valid_grid(const InputFile& file, vtkUnstructuredGrid& grid) {
  require_valid(file, grid.GetCells(), grid.GetNumberOfPoints(), 0);
  for (vtkIdType c = 0; c < grid.GetNumberOfCells(); ++c) {
    const int type = grid.GetCellType(c);
    const vtkIdType found = grid.GetCells()->GetCellSize(c);
    const auto wanted = corners_of_type(type);
    if (wanted.most < wanted.least)
      file.fail("cell " + std::to_string(c) + " (counted from 0) is of VTK's type " + std::to_string(type) +
                ", which is not read: export linear cells");
    if (wanted.least > found || found > wanted.most)
      file.fail("cell " + std::to_string(c) + " (counted from 0) of type " + std::to_string(type) + " has " +
                std::to_string(found) + " corners (damaged)");
  }
}

void require_valid_cells(const InputFile& file, vtkPointSet& data) {
  const vtkIdType n_points = data.GetNumberOfPoints();
  if (auto* poly = vtkPolyData::SafeDownCast(&data)) {
    for (const auto& [cells, least] : {std::pair(poly->GetVerts(), 1), std::pair(poly->GetLines(), 2),
                                       std::pair(poly->GetPolys(), 3), std::pair(poly->GetStrips(), 3)})
      require_valid(file, cells, n_points, least);
  } else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(&data)) {
    require_valid_grid(file, *grid);
  }
}

void add_polyline(vtkCell& cell, vtkPointSet& data, const InputFile& file, FileContents& contents) {
  Polyline line{file.path.stem().string() + "__" + std::to_string(contents.polylines.size() + 1), file.shown(), {}};
  for (vtkIdType k = 0; k < cell.GetNumberOfPoints(); ++k) {
    Vec3 p;
    data.GetPoint(cell.GetPointId(k), &p.x);
    line.points.push_back(p);
  }
  contents.polylines.push_back(std::move(line));
}

void add_cells(const InputFile& file, vtkPointSet& data, SurfaceBuilder& builder, FileContents& contents,
               CellCounts& counts) {
  std::vector<std::int64_t> polygon;
  const vtkIdType n = data.GetNumberOfCells();
  for (vtkIdType c = 0; c < n; ++c) {
    vtkCell& cell = *data.GetCell(c);
    const vtkIdType n_corners = cell.GetNumberOfPoints();
    if (cell.GetCellDimension() == 1) {
      add_polyline(cell, data, file, contents);
    } else if (cell.GetCellDimension() != 2) {
      ++(cell.GetCellDimension() == 3 ? counts.volumes : counts.points);
    } else if (cell.GetCellType() == VTK_TRIANGLE_STRIP) {
      for (vtkIdType k = 0; k + 2 < n_corners; ++k) {
        const vtkIdType odd = k % 2;
        builder.add_polygon({cell.GetPointId(k), cell.GetPointId(k + 1 + odd), cell.GetPointId(k + 2 - odd)}, 0);
      }
    } else {
      polygon.clear();
      for (vtkIdType k = 0; k < n_corners; ++k) polygon.push_back(cell.GetPointId(k));
      if (cell.GetCellType() == VTK_PIXEL) std::swap(polygon[2], polygon[3]);
      builder.add_polygon(polygon, 0);
    }
  }
}

}  // namespace

bool is_vtk_xml(const InputFile& file) {
  const std::string_view head = file.text().substr(0, 2048);
  return head.find("<VTKFile") != std::string_view::npos;
}

FileContents read_vtk_xml(const InputFile& file) {
  const std::string_view head = file.text().substr(0, 4096);
  const bool poly = head.find("\"PolyData\"") != std::string_view::npos;
  if (!poly && head.find("\"UnstructuredGrid\"") == std::string_view::npos) {
    file.fail("the VTK file holds neither PolyData nor UnstructuredGrid");
  }
  if (file.text().substr(file.size() - std::min<std::size_t>(file.size(), 256)).find("</VTKFile>") ==
      std::string_view::npos) {
    file.fail("the VTK file has no </VTKFile> at its end (truncated)");
  }
  const vtkSmartPointer<vtkPointSet> data = poly ? parse_vtk<vtkXMLPolyDataReader, vtkPointSet>(file)
                                                 : parse_vtk<vtkXMLUnstructuredGridReader, vtkPointSet>(file);
  SurfaceBuilder builder(file);
  FileContents contents;
  CellCounts counts;
  require_valid_cells(file, *data);
  add_points(file, *data, builder);
  add_cells(file, *data, builder, contents, counts);
  if (builder.empty() && contents.polylines.empty()) {
    file.fail(counts.volumes > 0 ? "it holds volume cells and no triangle: it is a mesh, not a surface"
                                 : "the surface is empty: the file holds no triangle");
  }
  list_arrays(*data->GetPointData(), contents);
  list_arrays(*data->GetCellData(), contents);
  contents.format = poly ? "VTK PolyData" : "VTK UnstructuredGrid";
  if (counts.volumes > 0) contents.warnings.push_back(std::to_string(counts.volumes) + " volume cells are passed over");
  if (counts.points > 0) contents.notes.push_back(std::to_string(counts.points) + " point cells are passed over");
  note_split_polygons(builder.n_split(), contents);
  if (!builder.empty()) contents.surfaces.push_back(builder.take());
  return contents;
}

}  // namespace geomesh::geomodel
