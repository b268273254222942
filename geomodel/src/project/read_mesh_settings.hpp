// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The keys of `mesh` that speak of sizes, shapes and surfaces (docs/meshing.md).
#pragma once

#include <string_view>
#include <vector>

#include "geomesh/geomodel/project.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

/// The keys that read_refinement knows, for the map of all keys of `mesh`.
const std::vector<std::string_view>& refinement_keys();

/// What a project without `mesh` asks for: sizes derived from the model, surfaces within a tolerance that follows them.
/// Nothing with crs.z_scale.
void default_refinement(Project& project);

/// Reads them into project.mesh.refinement. A size or a quality asks for refinement where `refine` is not given. Names
/// of surfaces and points are checked against the project, which has been read but for `output`.
void read_refinement(const YamlMap& mesh, Project& project);

}  // namespace geomesh::geomodel
