// SPDX-License-Identifier: GPL-3.0-or-later
#include "given_type.hpp"

#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "arrays.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/readers.hpp"

namespace geomesh::python {
namespace {

using geomodel::FileContents;

/// Returns a Python object that keeps the contents in memory as long as numpy arrays that view them exist.
py::capsule owner_of(const Given& given) {
  auto* const held = new std::shared_ptr<const FileContents>(given.contents);
  return {held, [](void* p) { delete static_cast<std::shared_ptr<const FileContents>*>(p); }};
}

py::list surfaces_of(const Given& given) {
  const py::capsule owner = owner_of(given);
  py::list list;
  for (const geomodel::TriangulatedSurface& s : given.contents->surfaces)
    list.append(py::make_tuple(s.name, view_points(s.points, owner), view_rows(s.triangles, owner)));
  return list;
}

/// Returns (name, points) of each point set or other named object of an input.
template <class Object>
py::list points_of(const Given& given, const std::vector<Object>& objects) {
  const py::capsule owner = owner_of(given);
  py::list list;
  for (const Object& object : objects) list.append(py::make_tuple(object.name, view_points(object.points, owner)));
  return list;
}

template <class Object>
void replace_points(std::vector<Object>& objects, std::size_t row, const PointArray& points) {
  const std::span<const Vec3> rows = as_points(points, "points");
  if (row >= objects.size() || objects[row].points.size() != rows.size())
    throw Error(ErrorKind::usage, "moved: there is no such object, or it has another number of points");
  objects[row].points.assign(rows.begin(), rows.end());
}

/// Returns a copy of an input with other points for one surface or other object; everything else is unchanged.
Given moved(const Given& given, const std::string& kind, std::size_t row, const PointArray& points) {
  FileContents contents = *given.contents;
  if (kind == "surface")
    replace_points(contents.surfaces, row, points);
  else
    replace_points(contents.point_sets, row, points);
  return share(std::move(contents));
}

}  // namespace

void define_given(py::module_& module) {
  py::class_<Given>(module, "Given")
      .def_property_readonly("surfaces", &surfaces_of)
      .def_property_readonly("point_sets", [](const Given& g) { return points_of(g, g.contents->point_sets); })
      .def_property_readonly("polylines", [](const Given& g) { return points_of(g, g.contents->polylines); })
      .def_property_readonly("z_is_named", [](const Given& g) { return g.contents->frame.z_named; })
      .def("moved", &moved);
  module.def("read_given", [](const std::string& file) { return share(geomodel::read_surface_file(file)); });
}

}  // namespace geomesh::python
