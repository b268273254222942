// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Points for `geomesh delaunay`: lines of x y z (blanks, tabs, commas or semicolons between; a header line allowed),
/// or the vertices of any surface file.
#pragma once

#include <filesystem>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Throws Error{usage} where the file cannot be opened, Error{invalid_input} with file and line where a line is not
/// three numbers.
std::vector<Vec3> read_points(const std::filesystem::path& path);

}  // namespace geomesh::geomodel
