// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Surfaces and lines in legacy VTK files (.vtk); the functions are like those in readers/formats.hpp.
#pragma once

#include "geomesh/geomodel/surface.hpp"
#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {

bool is_vtk_legacy(const InputFile& file);
FileContents read_vtk_legacy(const InputFile& file);

}  // namespace geomesh::geomodel
