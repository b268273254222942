// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include "geomesh/geomodel/arrangement.hpp"
#include "writers/vtk_arrays.hpp"

namespace geomesh::geomodel {
namespace {

vtkSmartPointer<vtkStringArray> surface_names(const std::vector<TriangulatedSurface>& surfaces, const ArrangementResult& result) {
  return string_array("surface_names", surfaces.size() + result.box_sides.size(), [&](std::size_t s) {
    return s < surfaces.size() ? surfaces[s].name : result.box_sides[s - surfaces.size()].name;
  });
}

void write_spots_vtp(const ArrangementResult& result, const std::vector<TriangulatedSurface>& surfaces, const std::filesystem::path& file) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  std::vector<Vec3> places;
  for (const Spot& spot : result.spots) places.push_back(spot.place);
  data->SetPoints(vtk_points(places));
  auto vertices = vtkSmartPointer<vtkCellArray>::New();
  for (vtkIdType k = 0; k < static_cast<vtkIdType>(places.size()); ++k) vertices->InsertNextCell(1, &k);
  data->SetVerts(vertices);
  vtkCellData& cells = *data->GetCellData();
  const auto& spots = result.spots;
  cells.AddArray(string_array("what", spots.size(), [&](std::size_t k) { return spots[k].what; }));
  cells.AddArray(int_array("surface_a", spots.size(), [&](std::size_t k) { return static_cast<int>(spots[k].surface_a); }));
  cells.AddArray(int_array("surface_b", spots.size(), [&](std::size_t k) { return static_cast<int>(spots[k].surface_b); }));
  cells.AddArray(int_array("count", spots.size(), [&](std::size_t k) { return spots[k].count; }));
  auto measure = vtkSmartPointer<vtkDoubleArray>::New();
  measure->SetName("measure");
  for (const Spot& spot : spots) measure->InsertNextValue(spot.measure);
  cells.AddArray(measure);
  data->GetFieldData()->AddArray(surface_names(surfaces, result));
  auto writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
  write_vtk_xml(*writer, *data, file);
}

void write_facets_vtp(const ArrangementResult& result, const std::vector<TriangulatedSurface>& surfaces, const std::filesystem::path& file) {
  const PolygonSoup& soup = result.soup;
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(soup.points));
  auto lines = vtkSmartPointer<vtkCellArray>::New(), polygons = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& s : soup.segments) {
    const std::array<vtkIdType, 2> ids{s.a, s.b};
    lines->InsertNextCell(2, ids.data());
  }
  for (const auto& [a, b, c] : soup.facets) {
    const std::array<vtkIdType, 3> ids{a, b, c};
    polygons->InsertNextCell(3, ids.data());
  }
  data->SetLines(lines);
  data->SetPolys(polygons);
  // Cell data go lines first, then polygons.
  const std::size_t n_lines = soup.segments.size(), n = n_lines + soup.facets.size();
  const auto facet_value = [&](std::size_t cell, auto&& value) { return cell < n_lines ? -1 : static_cast<int>(value(cell - n_lines)); };
  const auto first = [&](std::size_t f) -> const PolygonSoup::Origin& { return soup.origins[soup.origin_offsets[f]]; };
  vtkCellData& cells = *data->GetCellData();
  cells.AddArray(int_array("surface", n, [&](std::size_t c) { return facet_value(c, [&](std::size_t f) { return first(f).surface; }); }));
  cells.AddArray(int_array("source_triangle", n, [&](std::size_t c) { return facet_value(c, [&](std::size_t f) { return first(f).triangle; }); }));
  cells.AddArray(int_array("n_origins", n, [&](std::size_t c) {
    return facet_value(c, [&](std::size_t f) { return soup.origin_offsets[f + 1] - soup.origin_offsets[f]; });
  }));
  cells.AddArray(int_array("polyline", n, [&](std::size_t c) { return c < n_lines ? static_cast<int>(soup.segments[c].polyline) : -1; }));
  data->GetPointData()->AddArray(int_array("kind", soup.points.size(), [&](std::size_t v) { return static_cast<int>(soup.kind[v]); }));
  data->GetFieldData()->AddArray(surface_names(surfaces, result));
  auto writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
  write_vtk_xml(*writer, *data, file);
}

}  // namespace

std::vector<std::filesystem::path> write_arrangement_vtp(const ArrangementResult& result, const std::vector<TriangulatedSurface>& surfaces,
                                                         const std::filesystem::path& stem) {
  const std::filesystem::path soup = stem.string() + ".soup.vtp", spots = stem.string() + ".spots.vtp";
  write_facets_vtp(result, surfaces, soup);
  write_spots_vtp(result, surfaces, spots);
  return {soup, spots};
}

}  // namespace geomesh::geomodel
