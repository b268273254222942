// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The surfaces of a project that are level sets of fields, as triangulations for the front end.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geomesh/geomodel/project.hpp"

namespace geomesh::geomodel {

/// Of the distance that surfaces may be off the input, what the triangulation of a level set uses up; the rest is left
/// to the mesh. A smaller share costs triangles (as its inverse), a larger one elements.
inline constexpr double level_set_share = 0.25;

bool has_level_sets(const Project& project);

struct LevelSurfaces {
  std::map<std::size_t, FileContents> contents;  ///< by row of the project's surfaces
  /// By row of the project's surfaces: which triangles come from which field, in the order of SurfaceSpec::level_sets,
  /// and what was not proven of them.
  std::map<std::size_t, std::vector<FieldPart>> parts;
  std::vector<std::string> notes, warnings;
};

/// Surfaces of the same field (file and array, or function) come from one mesh, so that they never cross. Surfaces are
/// whole: where a field has a domain, they are cut off there in the arranged model (trim_soup). Coordinates
/// are those of the project file. Throws Error{invalid_input} with surface and place: a field that cannot be read, does
/// not reach the box, has no such value there, or a function that throws or gives no finite value; Error{usage} where a
/// function has no box to hold in.
LevelSurfaces make_level_surfaces(const Project& project);

}  // namespace geomesh::geomodel
