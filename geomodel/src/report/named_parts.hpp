// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Lists the named regions, surfaces and curves of a mesh for reports.
#pragma once

#include <nlohmann/json.hpp>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Returns the report's members `regions`, `surfaces` and `curves` (including named points), with ids and measures.
nlohmann::ordered_json named_parts_json(const ModelMesh& mesh);

}  // namespace geomesh::geomodel
