// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Fault zones of a project: the rules for their regions, and the mesh opened to them.
#pragma once

#include <vector>

#include "fault_zones/fault_zones.hpp"
#include "geomesh/geomodel/build_model.hpp"

namespace geomesh::geomodel {

/// Takes groups and attributes that name zones out of the rules, because there are no zones yet while the mesh is
/// named.
NamingRules take_zone_rules(NamingRules& rules, const std::vector<FaultZone>& zones);

/// Calls open_fault_zones(), and adds the groups and attributes that `zone_rules` give to zones.
ModelMesh open_project_zones(const ModelMesh& mesh, const std::vector<FaultZone>& zones, const NamingRules& zone_rules);

}  // namespace geomesh::geomodel
