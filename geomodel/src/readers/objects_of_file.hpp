// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Divides the contents of an input file into its objects: surfaces, point sets and named lines.
#pragma once

#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Divides the contents of one file into several, one for each surface and each point set. All have the format and the
/// coordinate frame of the file; its warnings and notes are in the first one.
std::vector<FileContents> objects_of_file(const FileContents& contents);

/// Returns the contents of a file with only the surface or point set of this name; without any object if there is none.
FileContents object_named(const FileContents& contents, const std::string& name);

}  // namespace geomesh::geomodel
