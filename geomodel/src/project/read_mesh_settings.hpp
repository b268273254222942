// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads the keys of `mesh` for sizes, shapes and surfaces (docs/meshing.md).
#pragma once

#include <string_view>
#include <vector>

#include "geomesh/geomodel/project.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

/// Returns the keys that read_refinement reads, for the list of all keys of `mesh`.
const std::vector<std::string_view>& refinement_keys();

/// Sets the defaults of a project without `mesh`: sizes derived from the model, and surfaces within a tolerance that
/// follows them. Does nothing with crs.z_scale.
void default_refinement(Project& project);

/// Reads these keys into project.mesh.refinement. If `refine` is not given, a size or a quality turns refinement on.
/// Names of surfaces and points are checked against the project, of which everything but `output` was read before.
void read_refinement(const YamlMap& mesh, Project& project);

}  // namespace geomesh::geomodel
