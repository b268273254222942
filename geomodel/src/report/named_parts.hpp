// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The named parts of a mesh, as reports list them.
#pragma once

#include <nlohmann/json.hpp>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// Returns `regions`, `surfaces` and `curves` (including named points) with ids, kinds and measures.
nlohmann::ordered_json named_parts_json(const ModelMesh& mesh);

}  // namespace geomesh::geomodel
