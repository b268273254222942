// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Triangulates the surfaces of a project that are level sets of scalar fields.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geomesh/geomodel/project.hpp"

namespace geomesh::geomodel {

/// Share of the tolerance of surfaces that the triangulation of a level set uses; the rest is left for the mesh. The
/// number of triangles grows with the inverse of the share, the number of elements with the share.
inline constexpr double level_set_share = 0.25;

bool has_level_sets(const Project& project);

struct LevelSurfaces {
  std::map<std::size_t, FileContents> contents;  ///< contents of each level set, by row of the project's surfaces
  /// For each level set, by row of the project's surfaces: which of its triangles come from which field, in the order
  /// of SurfaceSpec::level_sets, and what could not be proven about them.
  std::map<std::size_t, std::vector<FieldPart>> parts;
  std::vector<std::string> notes, warnings;
};

/// Triangulates all surfaces of a project that are level sets. Surfaces of the same field (file and array, or function)
/// are made from one background mesh, so that they never cross. If a field is valid only in some domain, its surfaces
/// are cut off at the bounds of the domain later, in the arranged model (trim_soup). Coordinates are those of the
/// project file. Throws Error{invalid_input} with surface and place for a field that cannot be read, does not reach the
/// box or never has the requested value, and for a function that throws or gives no finite value; throws Error{usage}
/// if there is a function and no box in which to evaluate it.
LevelSurfaces make_level_surfaces(const Project& project);

}  // namespace geomesh::geomodel
