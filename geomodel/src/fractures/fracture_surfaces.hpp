// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads fractures from files of surfaces and lines: GOCAD, DXF, OBJ, STL and the like, shapefiles and GeoJSON.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fractures/fracture.hpp"

namespace geomesh::geomodel {

/// Decides by the extension: text of numbers is a table of fractures, whatever else it could be.
bool is_file_of_surfaces(const std::filesystem::path& path);

/// Returns one fracture for each connected surface, by its border, and for each closed line. It has the name of its
/// object; if an object has several, or several have one name, a number is added. Objects without a name are `name`_1,
/// ... Throws Error{invalid_input} with file and object as the readers, and if a surface has holes or is not plane, or
/// a line is open.
std::vector<Fracture> fractures_of_surfaces(const std::filesystem::path& path, const std::string& name);

}  // namespace geomesh::geomodel
