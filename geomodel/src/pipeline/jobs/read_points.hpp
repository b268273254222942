// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads points for `geomesh delaunay`: lines of x y z (separated by blanks, tabs, commas or semicolons; a header line
/// is allowed), or the vertices of any surface file.
#pragma once

#include <filesystem>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Reads points from a text or surface file. Throws Error{usage} if the file cannot be opened, Error{invalid_input}
/// with file and line if a line does not have three numbers.
std::vector<Vec3> read_points(const std::filesystem::path& path);

}  // namespace geomesh::geomodel
