// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Triangulates the surfaces of a project that are level sets of fields.
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
  std::map<std::size_t, FileContents> contents;  ///< contents by row of the project's surfaces
  /// By row of the project's surfaces: which triangles come from which field, in the order of SurfaceSpec::level_sets,
  /// and what could not be proven about them.
  std::map<std::size_t, std::vector<FieldPart>> parts;
  std::vector<std::string> notes, warnings;
};

/// Surfaces of the same field (file and array, or function) come from one mesh, so that they never cross. They are
/// made without regard to domains: if a field has one, they are cut off at its bounds in the arranged model
/// (trim_soup). Coordinates are those of the project file. Throws Error{invalid_input} with surface and place: a field
/// that cannot be read, does not reach the box, has no such value there, or a function that throws or gives no finite
/// value; Error{usage} if there is a function and no box in which to evaluate it.
LevelSurfaces make_level_surfaces(const Project& project);

}  // namespace geomesh::geomodel
