// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Fault zones of a project: naming rules for the regions of zones, and the mesh with zones opened.
#pragma once

#include <vector>

#include "fault_zones/fault_zones.hpp"
#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel {

/// Removes groups and attributes of fault zones from the naming rules and returns them, because there are no zones yet
/// when the mesh is named.
NamingRules take_zone_rules(NamingRules& rules, const std::vector<FaultZone>& zones);

/// Calls open_fault_zones(), and adds the groups and attributes that `zone_rules` define for zones.
ModelMesh open_project_zones(const ModelMesh& mesh, const std::vector<FaultZone>& zones, const NamingRules& zone_rules);

}  // namespace geomesh::geomodel
