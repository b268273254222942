// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The two sides, NAME.minus and NAME.plus, of a surface along which a mesh was opened (docs/outputs.md).
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "mesh_readers/mesh_files.hpp"

namespace geomesh::geomodel::checking {

enum class Wall { none, minus, plus };

/// Splits the name of a wall, NAME.minus or NAME.plus, into surface and side. For any other name, returns the name
/// itself and no side.
inline std::pair<std::string, Wall> wall_of(const std::string& name, const std::vector<std::string>& opened) {
  for (const std::string& surface : opened) {
    if (name == surface + ".minus") return {surface, Wall::minus};
    if (name == surface + ".plus") return {surface, Wall::plus};
  }
  return {name, Wall::none};
}

/// Returns the wall of a split fault or a fault zone to which a mesh face belongs. The first surface of the face
/// decides; if it is no wall, the other surfaces that coincide there do.
inline Wall wall_of_face(const FacesFile& faces, std::size_t f, const std::vector<std::string>& opened) {
  const auto wall_of_id = [&](std::int32_t id) {
    const auto name = faces.surface_names.find(id);
    return name == faces.surface_names.end() ? Wall::none : wall_of(name->second, opened).second;
  };
  if (const Wall own = wall_of_id(faces.surface[f]); own != Wall::none) return own;
  const auto row = static_cast<std::size_t>(faces.surface_set[f]);
  if (row < faces.surface_sets.size())
    for (const std::int32_t id : faces.surface_sets[row])
      if (const Wall wall = wall_of_id(id); wall != Wall::none) return wall;
  return Wall::none;
}

/// Returns whether the face set gives a mesh point for each of its points.
inline bool knows_mesh_points(const FacesFile& faces, std::size_t n_points) {
  return faces.mesh_point.size() == faces.points.size() &&
         std::all_of(faces.mesh_point.begin(), faces.mesh_point.end(),
                     [&](std::int32_t row) { return row >= 0 && static_cast<std::size_t>(row) < n_points; });
}

}  // namespace geomesh::geomodel::checking
