// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Splits a file into the objects that it contains.
#pragma once

#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Returns the contents of one file as several, one for each surface and each point set. All have the format and the
/// frame of the file; its warnings and notes are in the first one.
std::vector<FileContents> objects_of_file(const FileContents& contents);

/// Returns the contents of a file with only the surface or point set of this name; without any object if there is none.
FileContents object_named(const FileContents& contents, const std::string& name);

}  // namespace geomesh::geomodel
