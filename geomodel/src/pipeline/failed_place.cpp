// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/failed_place.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "geomesh/geomodel/writers.hpp"
#include "writers/vtk_arrays.hpp"

namespace geomesh::geomodel {
namespace {

vtkSmartPointer<vtkUnstructuredGrid> cells_of(const MeshExcerpt& place) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(vtk_points(place.points));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const Tetrahedron& t : place.tetrahedra) cells->InsertNextCell({t[0], t[1], t[2], t[3]});
  grid->SetCells(VTK_TETRA, cells);
  return grid;
}

/// In the order of VTK: vertices, lines, polygons.
vtkSmartPointer<vtkPolyData> constraints_of(const MeshExcerpt& place, const ModelPlc& model, const PolygonSoup& soup,
                                            const std::vector<TriangulatedSurface>& surfaces) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(place.points));
  auto vertices = vtkSmartPointer<vtkCellArray>::New(), lines = vtkSmartPointer<vtkCellArray>::New(),
       triangles = vtkSmartPointer<vtkCellArray>::New();
  for (const VertexIndex v : place.culprits) vertices->InsertNextCell({v});
  for (const auto& s : place.segments) lines->InsertNextCell({s[0], s[1]});
  for (const Triangle& t : place.triangles) triangles->InsertNextCell({t[0], t[1], t[2]});
  data->SetVerts(vertices);
  data->SetLines(lines);
  data->SetPolys(triangles);
  const std::size_t n_vertices = place.culprits.size(), n_lines = place.segments.size(),
                    n = n_vertices + n_lines + place.triangles.size();
  data->GetCellData()->AddArray(int_array("what", n, [&](std::size_t i) {
    return i < n_vertices ? 0 : i < n_vertices + n_lines ? 1 : 2;
  }));
  data->GetCellData()->AddArray(int_array("surface", n, [&](std::size_t i) {
    if (i < n_vertices + n_lines) return -1;
    const Index first_soup_facet = model.facet_soup[model.facet_soup_offsets[place.facet[i - n_vertices - n_lines]]];
    return static_cast<int>(soup.origins[soup.origin_offsets[first_soup_facet]].surface);
  }));
  data->GetFieldData()->AddArray(
      string_array("surface_names", surfaces.size(), [&](std::size_t s) { return surfaces[s].name; }));
  return data;
}

template <class Writer, class Data>
std::filesystem::path write(Data& data, const std::filesystem::path& file) {
  write_complete_or_absent(file, [&](const std::filesystem::path& temporary) {
    auto writer = vtkSmartPointer<Writer>::New();
    write_vtk_xml(*writer, data, temporary);
  });
  return file;
}

}  // namespace

std::vector<std::filesystem::path> write_failed_place(const MeshExcerpt& place, const ModelPlc& model,
                                                      const PolygonSoup& soup,
                                                      const std::vector<TriangulatedSurface>& surfaces,
                                                      const std::filesystem::path& stem) {
  return {write<vtkXMLUnstructuredGridWriter>(*cells_of(place), stem.string() + ".failed.vtu"),
          write<vtkXMLPolyDataWriter>(*constraints_of(place, model, soup, surfaces), stem.string() + ".failed.vtp")};
}

}  // namespace geomesh::geomodel
