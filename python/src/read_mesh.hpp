// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Mesh files as results: what `geomesh.read` returns.
#pragma once

#include <string>

#include "geomesh/geomodel/pipeline.hpp"

namespace geomesh::python {

/// A mesh file of any tool that `geomesh convert` reads, with volumes, areas and lengths measured. The mesh is as the
/// file has it, not verified. Throws as read_model_mesh.
geomodel::JobResult read_mesh(const std::string& file);

}  // namespace geomesh::python
