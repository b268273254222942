// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Names of the regions of fault zones, as documented in docs/outputs.md.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel::checking {

inline std::vector<std::string> faults_of(const std::vector<FaultZone>& zones) {
  std::vector<std::string> faults;
  for (const FaultZone& zone : zones) faults.push_back(zone.fault);
  return faults;
}

inline std::optional<std::size_t> zone_of_region(const std::string& name, const std::vector<FaultZone>& zones) {
  for (std::size_t z = 0; z < zones.size(); ++z)
    if (name == zones[z].fault + ".zone") return z;
  return std::nullopt;
}

/// Returns a map from the id of each region that is a fault zone to the zone's index.
inline std::map<std::int32_t, std::size_t> zone_ids(const std::map<std::int32_t, std::string>& region_names,
                                                    const std::vector<FaultZone>& zones) {
  std::map<std::int32_t, std::size_t> ids;
  for (const auto& [id, name] : region_names)
    if (const auto zone = zone_of_region(name, zones)) ids[id] = *zone;
  return ids;
}

}  // namespace geomesh::geomodel::checking
