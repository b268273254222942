// SPDX-License-Identifier: GPL-3.0-or-later
// NAME.faces.vtp and NAME.curves.vtp: constrained faces; curves and marked points.
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include "geomesh/geomodel/writers.hpp"
#include "writers/vtk_arrays.hpp"

namespace geomesh::geomodel {

namespace {

/// The points that a set of cells uses, in the order of the mesh, with their rows there as point array `mesh_point`.
class PointSubset {
 public:
  explicit PointSubset(std::size_t n_points) : row_(n_points, -1) {}
  void use(VertexIndex v) { row_[v] = 0; }
  void write(const ModelMesh& mesh, vtkPolyData& data) {
    std::vector<Vec3> points;
    std::vector<VertexIndex> rows;
    for (VertexIndex v = 0; v < row_.size(); ++v) {
      if (row_[v] < 0) continue;
      row_[v] = static_cast<vtkIdType>(points.size());
      points.push_back(mesh.points[v]);
      rows.push_back(v);
    }
    data.SetPoints(vtk_points(points));
    data.GetPointData()->AddArray(int_array("mesh_point", rows.size(), [&](std::size_t i) { return rows[i]; }));
  }
  vtkIdType operator[](VertexIndex v) const { return row_[v]; }

 private:
  std::vector<vtkIdType> row_;
};

/// Names of a set of surfaces: those of its members joined by `+`.
std::string set_name(const ModelMesh& mesh, const std::vector<std::int32_t>& set) {
  std::string name;
  for (std::int32_t id : set)
    for (const NamedSurface& s : mesh.surfaces)
      if (s.id == id) name += (name.empty() ? "" : "+") + s.name;
  return name;
}

/// Field data: `surface_set_names` by row, and the sets themselves as `surface_set_offsets` (one more than sets) into
/// `surface_set_ids`.
void add_surface_sets(const ModelMesh& mesh, vtkFieldData& field) {
  std::vector<std::size_t> offsets{0};
  std::vector<std::int32_t> ids;
  for (const auto& set : mesh.surface_sets) {
    ids.insert(ids.end(), set.begin(), set.end());
    offsets.push_back(ids.size());
  }
  field.AddArray(string_array("surface_set_names", mesh.surface_sets.size(),
                              [&](std::size_t i) { return set_name(mesh, mesh.surface_sets[i]); }));
  field.AddArray(int_array("surface_set_offsets", offsets.size(), [&](std::size_t i) { return offsets[i]; }));
  field.AddArray(int_array("surface_set_ids", ids.size(), [&](std::size_t i) { return ids[i]; }));
}

}  // namespace

void write_faces_vtp(const ModelMesh& mesh, const std::filesystem::path& file) {
  vtkSmartPointer<vtkPolyData> data = vtkSmartPointer<vtkPolyData>::New();
  PointSubset points(mesh.points.size());
  for (const auto& face : mesh.faces)
    for (VertexIndex v : face.vertices) points.use(v);
  points.write(mesh, *data);
  vtkSmartPointer<vtkCellArray> polys = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& face : mesh.faces) {
    const vtkIdType v[3] = {points[face.vertices[0]], points[face.vertices[1]], points[face.vertices[2]]};
    polys->InsertNextCell(3, v);
  }
  data->SetPolys(polys);
  const auto add = [&](const char* name, std::int32_t ModelMesh::Face::*member) {
    data->GetCellData()->AddArray(
        int_array(name, mesh.faces.size(), [&](std::size_t i) { return mesh.faces[i].*member; }));
  };
  add("surface", &ModelMesh::Face::surface);
  add("surface_set", &ModelMesh::Face::surface_set);
  add("patch", &ModelMesh::Face::patch);
  add("region_minus", &ModelMesh::Face::region_minus);
  add("region_plus", &ModelMesh::Face::region_plus);
  add("source_triangle", &ModelMesh::Face::source_triangle);
  add_surface_names(mesh, *data->GetFieldData());
  add_surface_sets(mesh, *data->GetFieldData());
  add_region_names(mesh, *data->GetFieldData());
  add_origin(mesh, *data->GetFieldData());
  vtkSmartPointer<vtkXMLPolyDataWriter> writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
  write_vtk_xml(*writer, *data, file);
}

void write_curves_vtp(const ModelMesh& mesh, const std::filesystem::path& file) {
  vtkSmartPointer<vtkPolyData> data = vtkSmartPointer<vtkPolyData>::New();
  PointSubset points(mesh.points.size());
  for (const auto& p : mesh.marked_points) points.use(p.v);
  for (const auto& e : mesh.curve_edges) {
    points.use(e.a);
    points.use(e.b);
  }
  points.write(mesh, *data);
  vtkSmartPointer<vtkCellArray> verts = vtkSmartPointer<vtkCellArray>::New(),
                                lines = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& p : mesh.marked_points) {
    const vtkIdType v = points[p.v];
    verts->InsertNextCell(1, &v);
  }
  for (const auto& e : mesh.curve_edges) {
    const vtkIdType v[2] = {points[e.a], points[e.b]};
    lines->InsertNextCell(2, v);
  }
  data->SetVerts(verts);
  data->SetLines(lines);
  const std::size_t n_points = mesh.marked_points.size();
  data->GetCellData()->AddArray(int_array("curve", n_points + mesh.curve_edges.size(), [&](std::size_t i) {
    return i < n_points ? mesh.marked_points[i].id : mesh.curve_edges[i - n_points].curve;
  }));
  vtkFieldData& field = *data->GetFieldData();
  const std::size_t n = mesh.curves.size() + n_points;
  const auto is_curve = [&](std::size_t i) { return i < mesh.curves.size(); };
  const auto point = [&](std::size_t i) -> const ModelMesh::MarkedPoint& {
    return mesh.marked_points[i - mesh.curves.size()];
  };
  field.AddArray(
      int_array("curve_ids", n, [&](std::size_t i) { return is_curve(i) ? mesh.curves[i].id : point(i).id; }));
  field.AddArray(
      string_array("curve_names", n, [&](std::size_t i) { return is_curve(i) ? mesh.curves[i].name : point(i).name; }));
  field.AddArray(
      string_array("curve_kinds", n, [&](std::size_t i) { return is_curve(i) ? mesh.curves[i].kind : "point"; }));
  add_origin(mesh, field);
  vtkSmartPointer<vtkXMLPolyDataWriter> writer = vtkSmartPointer<vtkXMLPolyDataWriter>::New();
  write_vtk_xml(*writer, *data, file);
}

}  // namespace geomesh::geomodel
