// SPDX-License-Identifier: MIT
#include <pybind11/numpy.h>

#include "geomesh/core/error.hpp"
#include "job.hpp"

namespace geomesh::python {
namespace {

void (*describe_further)(const Error& error, py::object& exception) = nullptr;

const char* class_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::usage:
      return "UsageError";
    case ErrorKind::invalid_input:
      return "InvalidInput";
    case ErrorKind::cannot_mesh:
      return "CannotMesh";
    case ErrorKind::interrupted:
      return "Interrupted";
  }
  return "Error";
}

/// Returns the places of an error as a new array: errors are rare and may outlive the data to which they refer.
py::array places_of(const Error& error) {
  const std::vector<Vec3>& places = error.context().places;
  py::array_t<double> array({places.size(), std::size_t{3}});
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) *array.mutable_data(i, k) = places[i][k];
  return array;
}

void set_error(const Error& error) {
  const py::object type = py::module_::import("geomesh.core.errors").attr(class_of(error.kind()));
  py::object exception = type(error.what());
  exception.attr("places") = places_of(error);
  py::list facets, vertices;
  for (const Index f : error.context().facets) facets.append(f);
  for (const VertexIndex v : error.context().vertices) vertices.append(v);
  exception.attr("facets") = facets;
  exception.attr("vertices") = vertices;
  if (describe_further) describe_further(error, exception);
  PyErr_SetObject(type.ptr(), exception.ptr());
}

}  // namespace

void register_errors(void (*describe)(const Error& error, py::object& exception)) {
  describe_further = describe;
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      set_error(error);
    } catch (const InternalError& error) {
      const py::object type = py::module_::import("geomesh.core.errors").attr("InternalError");
      PyErr_SetString(type.ptr(), error.what());
    }
  });
}

}  // namespace geomesh::python
