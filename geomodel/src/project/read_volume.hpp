// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads the key `box` of a project file: the model volume (docs/project-file.md).
#pragma once

#include "geomesh/geomodel/model_volume.hpp"
#include "geomesh/geomodel/project.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

/// Reads the key `box`. Returns nothing if it has errors, which are reported.
std::optional<VolumeSpec> read_volume(const YamlValue& value);

/// Resolves the surfaces named in the key `box`. Surfaces that close the volume are stored in project.naming.
void finish_volume(const YamlValue& root, Project& project);

}  // namespace geomesh::geomodel
