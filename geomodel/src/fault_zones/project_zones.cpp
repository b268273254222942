// SPDX-License-Identifier: GPL-3.0-or-later
#include "fault_zones/project_zones.hpp"

#include <algorithm>
#include <limits>

namespace geomesh::geomodel {

NamingRules take_zone_rules(NamingRules& rules, const std::vector<FaultZone>& zones) {
  NamingRules taken;
  for (const FaultZone& zone : zones) {
    const std::string name = zone_name(zone.fault);
    if (const auto at = rules.attributes.find(name); at != rules.attributes.end())
      taken.attributes.insert(rules.attributes.extract(at));
    for (auto& [group, members] : rules.groups)
      if (const auto at = std::find(members.begin(), members.end(), name); at != members.end()) {
        taken.groups[group].push_back(name);
        members.erase(at);
      }
  }
  return taken;
}

ModelMesh open_project_zones(const ModelMesh& mesh, const std::vector<FaultZone>& zones,
                             const NamingRules& zone_rules) {
  ModelMesh opened = open_fault_zones(mesh, zones);
  for (const auto& [name, values] : zone_rules.attributes)
    for (const Region& region : opened.regions) {
      if (region.name != name) continue;
      for (const auto& [attribute, value] : values) {
        auto& list = opened.attributes;
        auto at = std::find_if(list.begin(), list.end(),
                               [&attribute = attribute](const RegionAttribute& a) { return a.name == attribute; });
        if (at == list.end())
          at = list.insert(list.end(), {attribute, std::vector<double>(opened.regions.size(),
                                                                       std::numeric_limits<double>::quiet_NaN())});
        at->by_region[static_cast<std::size_t>(region.id - 1)] = value;
      }
    }
  for (const auto& [name, members] : zone_rules.groups)
    for (RegionGroup& group : opened.groups)
      if (group.name == name)
        for (const Region& region : opened.regions)
          if (std::find(members.begin(), members.end(), region.name) != members.end())
            group.regions.push_back(region.id);
  return opened;
}

}  // namespace geomesh::geomodel
