// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Converts the contents of an input file to metres with elevation up.
#pragma once

#include <string_view>

#include "geomesh/geomodel/surface.hpp"
#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {

/// Factors by which x and y, and z, are multiplied; that of z is negative to convert depth to elevation.
struct AxisScale {
  double xy = 1, z = 1;
};

/// Multiplies all coordinates in the contents of a file by the factors of their axes. If z changes its sign, triangles
/// are inverted, so that normals stay on their side, except triangles of grids, whose normals already point up.
void scale_contents(FileContents& contents, const AxisScale& scale);

/// Converts the contents of a file according to its own unit and direction of z (contents.frame), with notes. For
/// readers that do not convert coordinates. Throws Error{invalid_input} if a unit is one of time or unknown.
void convert_by_frame(const InputFile& file, FileContents& contents);

/// Meaning of the name of a z column, without its unit.
struct HeightColumn {
  bool is_height = false;
  bool depth = false;
  bool time = false;
};
HeightColumn height_column(std::string_view name);

}  // namespace geomesh::geomodel
