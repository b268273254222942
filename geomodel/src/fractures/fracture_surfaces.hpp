// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads fractures from files of surfaces and lines: GOCAD, DXF, OBJ, STL and the like, shapefiles and GeoJSON.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fractures/fracture.hpp"

namespace geomesh::geomodel {

/// Returns whether a file has surfaces or lines, according to its extension. Text files are tables of fractures.
bool is_file_of_surfaces(const std::filesystem::path& path);

/// Reads the fractures of a file: one for each connected surface, which its border defines, and one for each closed
/// line. A fracture has the name of its object; a number is added if an object has several fractures, or if several
/// objects have the same name. Objects without a name get the names `name`_1, ... Throws Error{invalid_input} with file
/// and object as the readers do, and if a surface has holes or is not plane, or if a line is open.
std::vector<Fracture> fractures_of_surfaces(const std::filesystem::path& path, const std::string& name);

}  // namespace geomesh::geomodel
