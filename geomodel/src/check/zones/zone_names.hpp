// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Names of zones' regions and walls, as docs/outputs.md tells them.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geomesh/geomodel/write_options.hpp"

namespace geomesh::geomodel::checking {

enum class Wall { none, minus, plus };

/// A wall's fault and side; of any other name the name itself and none.
inline std::pair<std::string, Wall> wall_of(const std::string& name, const std::vector<FaultZone>& zones) {
  for (const FaultZone& zone : zones) {
    if (name == zone.fault + ".minus") return {zone.fault, Wall::minus};
    if (name == zone.fault + ".plus") return {zone.fault, Wall::plus};
  }
  return {name, Wall::none};
}

/// Row of the zone whose region has this name.
inline std::optional<std::size_t> zone_of_region(const std::string& name, const std::vector<FaultZone>& zones) {
  for (std::size_t z = 0; z < zones.size(); ++z)
    if (name == zones[z].fault + ".zone") return z;
  return std::nullopt;
}

/// Ids of the zones' regions.
inline std::map<std::int32_t, std::size_t> zone_ids(const std::map<std::int32_t, std::string>& region_names,
                                                    const std::vector<FaultZone>& zones) {
  std::map<std::int32_t, std::size_t> ids;
  for (const auto& [id, name] : region_names)
    if (const auto zone = zone_of_region(name, zones)) ids[id] = *zone;
  return ids;
}

}  // namespace geomesh::geomodel::checking
