// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads `output` of a project file.
#pragma once

#include <filesystem>

#include "geomesh/geomodel/project.hpp"
#include "project/yaml_values.hpp"

namespace geomesh::geomodel {

/// `folder` is that of the project file. The surfaces were already read, since `split` names some of them.
void read_output(const YamlValue& value, const std::filesystem::path& folder, Project& project);

}  // namespace geomesh::geomodel
