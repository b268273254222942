// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/soup_vtp.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include "geomesh/geomodel/writers.hpp"
#include "writers/vtk_arrays.hpp"

namespace geomesh::geomodel {
namespace {

std::filesystem::path write_polydata(vtkPolyData& data, const std::filesystem::path& file) {
  write_complete_or_absent(file, [&](const std::filesystem::path& temporary) {
    auto writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
    write_vtk_xml(*writer, data, temporary);
  });
  return file;
}

vtkSmartPointer<vtkPolyData> soup_data(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(soup.points));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const Triangle& t : soup.facets) cells->InsertNextCell({t[0], t[1], t[2]});
  data->SetPolys(cells);
  const auto first = [&](std::size_t f) { return soup.origins[soup.origin_offsets[f]]; };
  const std::size_t n = soup.facets.size();
  data->GetCellData()->AddArray(int_array("surface", n, [&](std::size_t f) { return first(f).surface; }));
  data->GetCellData()->AddArray(int_array("source_triangle", n, [&](std::size_t f) { return first(f).triangle; }));
  data->GetCellData()->AddArray(
      int_array("n_origins", n, [&](std::size_t f) { return soup.origin_offsets[f + 1] - soup.origin_offsets[f]; }));
  data->GetPointData()->AddArray(
      int_array("kind", soup.points.size(), [&](std::size_t v) { return static_cast<int>(soup.kind[v]); }));
  vtkFieldData& field = *data->GetFieldData();
  field.AddArray(string_array("surface_names", surfaces.size(), [&](std::size_t s) { return surfaces[s].name; }));
  field.AddArray(
      int_array("origin_offsets", soup.origin_offsets.size(), [&](std::size_t i) { return soup.origin_offsets[i]; }));
  field.AddArray(
      int_array("origin_surfaces", soup.origins.size(), [&](std::size_t i) { return soup.origins[i].surface; }));
  field.AddArray(
      int_array("origin_triangles", soup.origins.size(), [&](std::size_t i) { return soup.origins[i].triangle; }));
  return data;
}

/// An edge on several curves is there once for each.
vtkSmartPointer<vtkPolyData> curve_data(const ModelPlc& model) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(vtk_points(model.plc.points));
  auto lines = vtkSmartPointer<vtkCellArray>::New();
  std::vector<Index> curve;
  for (std::size_t s = 0; s < model.plc.segments.size(); ++s)
    for (const Index c : model.segment_curves[s]) {
      lines->InsertNextCell({model.plc.segments[s].a, model.plc.segments[s].b});
      curve.push_back(c);
    }
  data->SetLines(lines);
  data->GetCellData()->AddArray(int_array("curve", curve.size(), [&](std::size_t i) { return curve[i]; }));
  const std::vector<SoupCurve>& curves = model.curves;
  data->GetFieldData()->AddArray(
      string_array("curve_names", curves.size(), [&](std::size_t i) { return curves[i].name; }));
  data->GetFieldData()->AddArray(
      string_array("curve_kinds", curves.size(), [&](std::size_t i) { return curves[i].kind; }));
  return data;
}

vtkSmartPointer<vtkPolyData> spot_data(const std::vector<Spot>& spots,
                                       const std::vector<TriangulatedSurface>& surfaces) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  std::vector<Vec3> places;
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const Spot& spot : spots) {
    cells->InsertNextCell({static_cast<vtkIdType>(places.size())});
    places.push_back(spot.place);
  }
  data->SetPoints(vtk_points(places));
  data->SetVerts(cells);
  const std::size_t n = spots.size();
  const auto name = [&](Index s) { return s < surfaces.size() ? surfaces[s].name : std::string(); };
  data->GetCellData()->AddArray(string_array("what", n, [&](std::size_t i) { return spots[i].what; }));
  data->GetCellData()->AddArray(string_array("surface_a", n, [&](std::size_t i) { return name(spots[i].surface_a); }));
  data->GetCellData()->AddArray(string_array("surface_b", n, [&](std::size_t i) { return name(spots[i].surface_b); }));
  data->GetCellData()->AddArray(int_array("count", n, [&](std::size_t i) { return spots[i].count; }));
  auto measure = vtkSmartPointer<vtkDoubleArray>::New();
  measure->SetName("measure");
  for (const Spot& spot : spots) measure->InsertNextValue(spot.measure);
  data->GetCellData()->AddArray(measure);
  data->GetCellData()->AddArray(
      string_array("description", n, [&](std::size_t i) { return describe(spots[i], surfaces); }));
  return data;
}

}  // namespace

std::vector<std::filesystem::path> write_soup_vtp(const ArrangementResult& arrangement, const ModelPlc& plc,
                                                  const std::vector<TriangulatedSurface>& surfaces,
                                                  const std::filesystem::path& stem) {
  return {write_polydata(*soup_data(arrangement.soup, surfaces), stem.string() + ".soup.vtp"),
          write_polydata(*curve_data(plc), stem.string() + ".soup.curves.vtp"),
          write_polydata(*spot_data(arrangement.spots, surfaces), stem.string() + ".spots.vtp")};
}

}  // namespace geomesh::geomodel
