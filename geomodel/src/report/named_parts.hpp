// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What of a mesh bears a name, as reports list it.
#pragma once

#include <nlohmann/json.hpp>

#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// `regions`, `surfaces` and `curves` (named points among them) with ids, kinds and measures.
nlohmann::ordered_json named_parts_json(const ModelMesh& mesh);

}  // namespace geomesh::geomodel
