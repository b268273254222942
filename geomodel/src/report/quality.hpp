// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Formats element quality as text and as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "geomesh/geomodel/report.hpp"

namespace geomesh::geomodel {

/// Returns the member `quality` of the report. `mesh` gives the names of regions.
nlohmann::ordered_json quality_json(const QualityReport& quality, const ModelMesh* mesh);
/// Returns the member `refinement` of the report; `quality` may be null.
nlohmann::ordered_json refinement_json(const RefineStatistics& statistics, const QualityReport* quality);

}  // namespace geomesh::geomodel
