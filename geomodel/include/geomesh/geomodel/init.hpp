// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `geomesh init`: writes a commented project with its own surfaces, which can be meshed without changes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace geomesh::geomodel {

/// Returns the names of the project templates that init_project accepts.
std::vector<std::string> template_names();

/// Writes `directory`/project.yaml, the surfaces of the template, and the JSON Schema with which editors check the
/// project. Returns the path of the project file. Throws Error{usage} if the template is unknown (the message lists the
/// known ones), if a project.yaml exists already, or if the folder cannot be made.
std::filesystem::path init_project(const std::filesystem::path& directory, const std::string& template_name);

}  // namespace geomesh::geomodel
