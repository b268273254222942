// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The named mesh in Python: numpy views of the arrays of ModelMesh.
#pragma once

#include <pybind11/pybind11.h>

#include "geomesh/geomodel/pipeline.hpp"

namespace geomesh::python {

void define_model_mesh(pybind11::module_& module);

}  // namespace geomesh::python
