// SPDX-License-Identifier: GPL-3.0-or-later
// The module geomesh._geomodel: inputs in memory, jobs on projects, and the named mesh. geomesh/*.py contain the
// classes and functions that users call, with their docstrings.
#include <pybind11/stl.h>

#include "arrays.hpp"
#include "geomesh/geomodel/check.hpp"
#include "geomesh/geomodel/given.hpp"
#include "geomesh/geomodel/model_error.hpp"
#include "geomesh/geomodel/pipeline.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "given_type.hpp"
#include "job.hpp"
#include "model_mesh_type.hpp"

namespace geomesh::python {
namespace {

namespace fs = std::filesystem;
using namespace geomodel;

std::vector<Vec3> copied(const PointArray& points, const char* what) {
  const std::span<const Vec3> rows = as_points(points, what);
  return {rows.begin(), rows.end()};
}

Given surface(const std::string& name, const PointArray& points, const py::array& triangles) {
  return share(given_surface(name, copied(points, "points"), as_triangles(triangles, "triangles")));
}

Given point_set(const std::string& name, const PointArray& points) {
  return share(given_points(name, copied(points, "points")));
}

Given polyline(const std::string& name, const PointArray& points) {
  return share(given_polyline(name, copied(points, "points")));
}

using HeightArray = py::array_t<double, py::array::c_style | py::array::forcecast>;

Given grid(const std::string& name, const HeightArray& heights, const std::array<double, 2>& origin,
           const std::array<double, 2>& spacing, double rotation) {
  if (heights.ndim() != 2) throw Error(ErrorKind::usage, name + ": heights of a grid are an array of two dimensions");
  GivenGrid g;
  g.n_rows = static_cast<std::size_t>(heights.shape(0));
  g.n_columns = static_cast<std::size_t>(heights.shape(1));
  g.heights = {heights.data(), static_cast<std::size_t>(heights.size())};
  g.origin = {origin[0], origin[1]};
  g.spacing = {spacing[0], spacing[1]};
  g.rotation = rotation;
  return share(given_grid(name, g));
}

/// Options with which Python runs a project: callbacks, size function, and output folder.
struct RunArguments {
  JobRequest job;
  py::object size_function;  ///< None, or the target size as f(x, y, z) in the project's coordinates
  std::optional<std::string> directory;
  bool write = false;
};

RunArguments run_arguments(const py::dict& given) {
  RunArguments a;
  a.job = {given["progress"], given["log"], given["threads"].cast<unsigned>()};
  a.size_function = given["size_function"];
  if (!given["directory"].is_none()) a.directory = given["directory"].cast<std::string>();
  a.write = given["write"].cast<bool>();
  return a;
}

using ProjectOfJob = std::function<Project(Job&)>;

JobResult run(const RunArguments& arguments, const ProjectOfJob& project) {
  Job job(arguments.job);
  ProjectRequest request;
  request.project = project(job);
  if (!arguments.size_function.is_none()) {
    const Vec3 origin = request.project.output.origin;
    auto size = job.size_function(arguments.size_function);
    request.project.mesh.refinement.size.base.background = [size = std::move(size), origin](const Vec3& p) {
      return size(p + origin);
    };
    request.project.mesh.refinement.refine = true;
    request.project.mesh.refinement.derive_size = false;
  }
  if (arguments.directory) request.directory = *arguments.directory;
  request.outputs = arguments.write ? ProjectRequest::Outputs::written : ProjectRequest::Outputs::kept;
  return job.run([&](const RunContext& context) { return run_project(request, context); });
}

/// Each function object of Python becomes one field, which all surfaces that use it share.
GivenFields given_fields(const py::dict& functions, Job& job) {
  std::map<PyObject*, std::shared_ptr<FieldFunction>> known;
  GivenFields fields;
  for (const auto& [name, function] : functions) {
    std::shared_ptr<FieldFunction>& field = known[function.ptr()];
    if (!field)
      field = std::make_shared<FieldFunction>(job.field_function(py::reinterpret_borrow<py::object>(function)));
    fields.emplace(name.cast<std::string>(), field);
  }
  return fields;
}

JobResult run_given(const std::string& text, const std::string& name, const std::string& folder,
                    const std::map<std::string, Given>& inputs, const py::dict& given) {
  GivenProject project{text, name, folder, {}, {}};
  for (const auto& [input, contents] : inputs) project.inputs.emplace(input, contents.contents);
  const RunArguments arguments = run_arguments(given);
  return run(arguments, [&](Job& job) {
    if (given.contains("fields")) project.fields = given_fields(given["fields"], job);
    return read_given_project(project);
  });
}

JobResult run_file(const std::string& file, const py::dict& given) {
  const RunArguments arguments = run_arguments(given);
  return run(arguments, [&](Job&) { return read_project(file); });
}

/// Returns (name, points, triangles) of each surface in a file, as separate arrays.
py::list read_surfaces(const std::string& file) {
  FileContents contents = read_surface_file(file);
  py::list list;
  for (TriangulatedSurface& s : contents.surfaces) {
    auto* const owned = new TriangulatedSurface(std::move(s));
    const py::capsule owner(owned, [](void* p) { delete static_cast<TriangulatedSurface*>(p); });
    list.append(py::make_tuple(owned->name, view_points(owned->points, owner), view_rows(owned->triangles, owner)));
  }
  return list;
}

std::string check(const std::string& mesh, const std::string& project) {
  const py::gil_scoped_release released;
  CheckRequest request;
  request.mesh = mesh;
  request.project = project;
  return to_json(check_mesh(request));
}

void add_items(const Error& error, py::object& exception) {
  const auto* const of_model = dynamic_cast<const ModelError*>(&error);
  if (!of_model) return;
  py::list surfaces, triangles;
  for (const std::string& name : of_model->items().surfaces) surfaces.append(name);
  for (const auto& t : of_model->items().triangles) triangles.append(py::make_tuple(t.surface, t.row));
  exception.attr("surfaces") = surfaces;
  exception.attr("triangles") = triangles;
}

}  // namespace
}  // namespace geomesh::python

PYBIND11_MODULE(_geomodel, module) {
  using namespace geomesh::python;
  module.doc() = "Projects and named meshes; use it through geomesh.";
  register_errors(&add_items);
  define_given(module);
  define_model_mesh(module);
  module.def("surface", &surface);
  module.def("point_set", &point_set);
  module.def("polyline", &polyline);
  module.def("grid", &grid);
  module.def("run_given", &run_given);
  module.def("run_file", &run_file);
  module.def("read_surfaces", &read_surfaces);
  module.def("check", &check);
}
