// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_mesh_type.hpp"

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/formats.hpp"
#include "geomesh/geomodel/viewer_page.hpp"
#include "mesh_bytes.hpp"
#include "read_mesh.hpp"
#include "write_keywords.hpp"

namespace geomesh::python {
namespace {

using geomodel::JobResult;
using geomodel::ModelMesh;
using Face = ModelMesh::Face;
using CurveEdge = ModelMesh::CurveEdge;

const ModelMesh& mesh_of(const py::object& self) { return self.cast<JobResult&>().mesh; }

template <class Member>
auto face_view(std::size_t width, Member member) {
  return [width, member](const py::object& self) { return view_member(mesh_of(self).faces, width, self, member); };
}

void define_arrays(py::class_<JobResult>& type) {
  type.def_property_readonly("points", [](const py::object& self) { return view_points(mesh_of(self).points, self); })
      .def_property_readonly("point_kind",
                             [](const py::object& self) { return view_numbers(mesh_of(self).point_kind, self); })
      .def_property_readonly("input_vertex",
                             [](const py::object& self) { return view_numbers(mesh_of(self).input_vertex, self); })
      .def_property_readonly("tetrahedra",
                             [](const py::object& self) { return view_rows(mesh_of(self).tetrahedra, self); })
      .def_property_readonly("region",
                             [](const py::object& self) { return view_numbers(mesh_of(self).tet_region, self); })
      .def_property_readonly("cell_arrays", [](const py::object& self) {
        py::dict arrays;
        for (const geomodel::CellArray& array : mesh_of(self).cell_arrays)
          arrays[py::str(array.name)] = view_numbers(array.values, self);
        return arrays;
      });
}

void define_faces(py::class_<JobResult>& type) {
  type.def_property_readonly("faces", face_view(3, [](const Face& f) { return f.vertices.data(); }))
      .def_property_readonly("face_surface", face_view(0, [](const Face& f) { return &f.surface; }))
      .def_property_readonly("face_surface_set", face_view(0, [](const Face& f) { return &f.surface_set; }))
      .def_property_readonly("face_patch", face_view(0, [](const Face& f) { return &f.patch; }))
      .def_property_readonly("face_region_minus", face_view(0, [](const Face& f) { return &f.region_minus; }))
      .def_property_readonly("face_region_plus", face_view(0, [](const Face& f) { return &f.region_plus; }))
      .def_property_readonly("face_source_triangle", face_view(0, [](const Face& f) { return &f.source_triangle; }))
      .def_property_readonly("surface_sets", [](const JobResult& r) { return r.mesh.surface_sets; });
}

void define_curves(py::class_<JobResult>& type) {
  static_assert(offsetof(CurveEdge, b) == offsetof(CurveEdge, a) + sizeof(VertexIndex));
  type.def_property_readonly("curve_edges",
                             [](const py::object& self) {
                               return view_member(mesh_of(self).curve_edges, 2, self,
                                                  [](const CurveEdge& e) { return &e.a; });
                             })
      .def_property_readonly("curve_of_edge", [](const py::object& self) {
        return view_member(mesh_of(self).curve_edges, 0, self, [](const CurveEdge& e) { return &e.curve; });
      });
}

py::list regions_of(const JobResult& r) {
  py::list list;
  for (const geomodel::Region& region : r.mesh.regions)
    list.append(py::make_tuple(region.id, region.name, region.unit, region.inside, region.n_tetrahedra, region.volume));
  return list;
}

py::list surfaces_of(const JobResult& r) {
  py::list list;
  for (const geomodel::NamedSurface& s : r.mesh.surfaces)
    list.append(py::make_tuple(s.id, s.name, geomodel::to_string(s.kind), s.area));
  return list;
}

py::list curves_of(const JobResult& r) {
  py::list list;
  for (const geomodel::NamedCurve& c : r.mesh.curves) list.append(py::make_tuple(c.id, c.name, c.kind, c.length));
  return list;
}

py::list marked_points_of(const JobResult& r) {
  py::list list;
  for (const ModelMesh::MarkedPoint& p : r.mesh.marked_points) list.append(py::make_tuple(p.id, p.name, p.v));
  return list;
}

py::dict attributes_of(const JobResult& r) {
  py::dict dict;
  for (const geomodel::RegionAttribute& a : r.mesh.attributes) dict[py::str(a.name)] = a.by_region;
  return dict;
}

/// Writes the mesh in one format and returns the names of the files. Each file is complete or absent.
std::vector<std::string> write(const JobResult& r, const std::string& format, const std::string& stem,
                               const py::dict& keywords) {
  const geomodel::WriteOptions options = write_options(keywords);
  std::vector<std::string> files;
  const py::gil_scoped_release released;
  for (const auto& file : geomodel::write_format(r.mesh, format, stem, options)) files.push_back(file.string());
  return files;
}

/// Returns the format of files with this extension (including the dot); empty if there is none.
std::string format_of_extension(const std::string& extension) {
  const geomodel::Format* const format = geomodel::format_of_extension(extension);
  return format ? format->name : std::string();
}

}  // namespace

void define_model_mesh(py::module_& module) {
  py::class_<JobResult> type(module, "JobResult");
  define_arrays(type);
  define_faces(type);
  define_curves(type);
  type.def_property_readonly("name", [](const JobResult& r) { return r.mesh.name; })
      .def_property_readonly("unit", [](const JobResult& r) { return r.mesh.unit; })
      .def_property_readonly(
          "shift", [](const JobResult& r) { return py::make_tuple(r.mesh.origin.x, r.mesh.origin.y, r.mesh.origin.z); })
      .def_property_readonly("regions", &regions_of)
      .def_property_readonly("surfaces", &surfaces_of)
      .def_property_readonly("curves", &curves_of)
      .def_property_readonly("marked_points", &marked_points_of)
      .def_property_readonly("attributes", &attributes_of)
      .def_readonly("report", &JobResult::report_json)
      .def_readonly("summary", &JobResult::summary)
      .def_readonly("warnings", &JobResult::warnings)
      .def_property_readonly("files",
                             [](const JobResult& r) {
                               std::vector<std::string> files;
                               for (const auto& file : r.files) files.push_back(file.string());
                               return files;
                             })
      .def_property_readonly("point_arrays",
                             [](const py::object& self) {
                               py::dict arrays;
                               for (const geomodel::PointArray& array : mesh_of(self).point_arrays)
                                 arrays[py::str(array.name)] = view_numbers(array.values, self);
                               return arrays;
                             })
      .def_property_readonly("groups",
                             [](const JobResult& r) {
                               py::dict groups;
                               for (const geomodel::RegionGroup& g : r.mesh.groups) groups[py::str(g.name)] = g.regions;
                               return groups;
                             })
      .def("write", &write)
      .def("viewer_page", [](const JobResult& r) { return geomodel::viewer_page(r.mesh); })
      .def(py::pickle([](const JobResult& r) { return py::bytes(bytes_of(r)); },
                      [](const py::bytes& bytes) { return result_of(std::string_view(bytes)); }));
  module.def("mesh_formats", &geomodel::mesh_formats);
  module.def("known_extensions", &geomodel::known_extensions);
  module.def("format_of_extension", &format_of_extension);
  module.def("read_mesh", &read_mesh, py::call_guard<py::gil_scoped_release>());
}

}  // namespace geomesh::python
