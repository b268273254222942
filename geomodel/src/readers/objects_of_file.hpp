// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A file that holds several objects, one by one.
#pragma once

#include <vector>

#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// One FileContents for each surface and each point set, with the file's format and frame; the file's warnings and
/// notes go with the first one.
std::vector<FileContents> objects_of_file(const FileContents& contents);

/// The contents with nothing but the surface or point set of this name; empty objects where there is none.
FileContents object_named(const FileContents& contents, const std::string& name);

}  // namespace geomesh::geomodel
