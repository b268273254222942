// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Key `box` of a project file: the model volume (docs/project-file.md).
#pragma once

#include "geomesh/geomodel/model_volume.hpp"
#include "geomesh/geomodel/project.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

/// Nothing where the key is wrong (reported).
std::optional<VolumeSpec> read_volume(const YamlValue& value);

/// Names in it, once the surfaces are known. Hands surfaces that close the volume on to project.naming.
void finish_volume(const YamlValue& root, Project& project);

}  // namespace geomesh::geomodel
