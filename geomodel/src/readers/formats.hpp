// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The readers, one format a file. `is_...` looks at the content (and at the extension only where the content cannot tell); `read_...`
/// throws Error{invalid_input} with file and line.
#pragma once

#include "geomesh/geomodel/surface.hpp"
#include "readers/input_file.hpp"

namespace geomesh::geomodel {

bool is_gocad(const InputFile& file);
FileContents read_gocad(const InputFile& file);

bool is_off(const InputFile& file);
FileContents read_off(const InputFile& file);

bool is_ply(const InputFile& file);
FileContents read_ply(const InputFile& file);

bool is_vtk_xml(const InputFile& file);
FileContents read_vtk_xml(const InputFile& file);

bool is_stl(const InputFile& file);
FileContents read_stl(const InputFile& file);

bool is_obj(const InputFile& file);
FileContents read_obj(const InputFile& file);

}  // namespace geomesh::geomodel
