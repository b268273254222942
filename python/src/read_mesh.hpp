// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Mesh files as results: the return value of `geomesh.read`.
#pragma once

#include <string>

#include "geomesh/geomodel/pipeline.hpp"

namespace geomesh::python {

/// Reads a mesh file of any tool that `geomesh convert` supports, with volumes, areas and lengths measured. The mesh is
/// not verified. Throws the errors of read_model_mesh.
geomodel::JobResult read_mesh(const std::string& file);

}  // namespace geomesh::python
