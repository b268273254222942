// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Element quality in words and in JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "geomesh/geomodel/report.hpp"

namespace geomesh::geomodel {

/// The member `quality` of the report. `mesh` names the regions.
nlohmann::ordered_json quality_json(const QualityReport& quality, const ModelMesh* mesh);
/// The member `refinement`.
nlohmann::ordered_json refinement_json(const RefineStatistics& statistics);

}  // namespace geomesh::geomodel
