// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Names the regions, surfaces and curves of a mesh, using the records of its model.
#pragma once

#include <string>
#include <vector>

#include "pipeline/records.hpp"

namespace geomesh::geomodel {

/// Returns the mesh with named regions, surfaces and curves, not verified. Appends the warnings of name_model().
ModelMesh named_mesh(const ModelRecords& model, const Meshed& meshed, std::vector<std::string>& warnings,
                     unsigned threads);

}  // namespace geomesh::geomodel
