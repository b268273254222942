// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Fault zones of a project: what it says of their regions, and the mesh opened to them.
#pragma once

#include <vector>

#include "fault_zones/fault_zones.hpp"
#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel {

/// Groups and attributes that name zones, taken out of the rules: while the mesh is named there are no zones yet.
NamingRules take_zone_rules(NamingRules& rules, const std::vector<FaultZone>& zones);

/// open_fault_zones(), with the groups and attributes that `zone_rules` give to zones.
ModelMesh open_project_zones(const ModelMesh& mesh, const std::vector<FaultZone>& zones, const NamingRules& zone_rules);

}  // namespace geomesh::geomodel
