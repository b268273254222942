// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads the keys of `mesh` in a project file for sizes, shapes and surfaces (docs/meshing.md).
#pragma once

#include <string_view>
#include <vector>

#include "geomesh/geomodel/project.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

/// Returns the keys that read_refinement reads, from which the list of all keys of `mesh` is made.
const std::vector<std::string_view>& refinement_keys();

/// Sets the default mesh settings of a project without `mesh`: sizes derived from the model, and surfaces within a
/// tolerance that follows the sizes. Does nothing if crs.z_scale is set.
void default_refinement(Project& project);

/// Reads the keys of `mesh` listed by refinement_keys() into project.mesh.refinement. If `refine` is not given, a size
/// or a quality turns refinement on. Names of surfaces and points are checked against the project. Precondition:
/// everything else in the project except `output` was read before.
void read_refinement(const YamlMap& mesh, Project& project);

}  // namespace geomesh::geomodel
