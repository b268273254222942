// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The Python type Given: the contents of one input of a project, made from arrays or read from a file.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <utility>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::python {

namespace py = pybind11;

/// Contents of an input, made once and shared with every project that uses it.
struct Given {
  std::shared_ptr<const geomodel::FileContents> contents;
};

inline Given share(geomodel::FileContents&& contents) {
  return {std::make_shared<const geomodel::FileContents>(std::move(contents))};
}

void define_given(py::module_& module);

}  // namespace geomesh::python
