// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Keyword arguments of Mesh.write as options for a file.
#pragma once

#include <pybind11/pybind11.h>

#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::python {

/// Converts keyword arguments, whose names are the keys of `output` in a project file. Throws Error{usage} for an
/// unknown key, or a value of another kind.
geomodel::WriteOptions write_options(const pybind11::dict& keywords);

}  // namespace geomesh::python
