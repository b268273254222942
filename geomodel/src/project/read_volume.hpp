// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads the key `box` of a project file: the model volume (docs/project-file.md).
#pragma once

#include "geomesh/geomodel/model_volume.hpp"
#include "geomesh/geomodel/project.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

/// Returns nothing if the key is wrong (which is reported).
std::optional<VolumeSpec> read_volume(const YamlValue& value);

/// Resolves names in it after the surfaces are known. Passes surfaces that close the volume to project.naming.
void finish_volume(const YamlValue& root, Project& project);

}  // namespace geomesh::geomodel
