// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads `output` of a project file.
#pragma once

#include <filesystem>

#include "geomesh/geomodel/project.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

/// Reads the key `output`. `folder` is that of the project file. Precondition: surfaces were read before, because
/// `split` names some of them.
void read_output(const YamlValue& value, const std::filesystem::path& folder, Project& project);

}  // namespace geomesh::geomodel
