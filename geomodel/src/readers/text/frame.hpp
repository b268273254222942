// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Converts the contents of a file to metres with elevation up.
#pragma once

#include <string_view>

#include "geomesh/geomodel/surface.hpp"
#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {

/// Factors of x and y, and of z (negative to convert depth to elevation).
struct AxisScale {
  double xy = 1, z = 1;
};

/// Applies the factors to everything that has coordinates. If z changes its sign, triangles are inverted, so that
/// normals stay on their side, except triangles of grids, whose normals already point up.
void scale_contents(FileContents& contents, const AxisScale& scale);

/// For formats that read coordinates as they are written: converts by contents.frame (unit, z_unit, depth), with notes.
/// Throws Error{invalid_input} if a unit is one of time or unknown.
void convert_by_frame(const InputFile& file, FileContents& contents);

/// Meaning of a column's name (without its unit) for z.
struct HeightColumn {
  bool is_height = false;
  bool depth = false;
  bool time = false;
};
HeightColumn height_column(std::string_view name);

}  // namespace geomesh::geomodel
