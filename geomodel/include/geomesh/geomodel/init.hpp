// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `geomesh init`: writes a commented project with its own surfaces, which can be run without changes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geomesh::geomodel {

/// Names accepted by init_project.
std::vector<std::string> template_names();

/// Writes `directory`/project.yaml, its surfaces, and the JSON Schema that editors check it with; returns the project
/// file. Throws Error{usage} where the template is unknown (lists the known ones), where a project.yaml is there
/// already, or where the folder cannot be made.
std::filesystem::path init_project(const std::filesystem::path& directory, const std::string& template_name);

}  // namespace geomesh::geomodel
