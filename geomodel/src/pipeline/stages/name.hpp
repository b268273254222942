// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Naming of a mesh of a model's records.
#pragma once

#include <string>
#include <vector>

#include "pipeline/records.hpp"

namespace geomesh::geomodel {

/// The mesh with its regions, sets and curves, not verified. Appends the warnings of name_model().
ModelMesh named_mesh(const ModelRecords& model, const Meshed& meshed, std::vector<std::string>& warnings,
                     unsigned threads);

}  // namespace geomesh::geomodel
