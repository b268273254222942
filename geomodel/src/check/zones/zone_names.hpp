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
#include "mesh_readers/mesh_files.hpp"

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

/// Of which wall a face is: by its first surface, else by any other of its set (a fault may lie in another one).
inline Wall wall_of_face(const FacesFile& faces, std::size_t f, const std::vector<FaultZone>& zones) {
  const auto wall_of_id = [&](std::int32_t id) {
    const auto name = faces.surface_names.find(id);
    return name == faces.surface_names.end() ? Wall::none : wall_of(name->second, zones).second;
  };
  if (const Wall own = wall_of_id(faces.surface[f]); own != Wall::none) return own;
  const auto row = static_cast<std::size_t>(faces.surface_set[f]);
  if (row < faces.surface_sets.size())
    for (const std::int32_t id : faces.surface_sets[row])
      if (const Wall wall = wall_of_id(id); wall != Wall::none) return wall;
  return Wall::none;
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
