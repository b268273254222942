// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Contents of a file brought to metres with elevation up.
#pragma once

#include <string_view>

#include "geomesh/geomodel/surface.hpp"
#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {

/// Factors of x and y, and of z (negative where depth becomes elevation).
struct AxisScale {
  double xy = 1, z = 1;
};

/// Applies the factors to everything that has coordinates. Where z changes its sign triangles are turned, so that
/// normals stay on their side. Those of grids are not: they were made with normals up.
void scale_contents(FileContents& contents, const AxisScale& scale);

/// For formats that read coordinates as they are written: converts by contents.frame (unit, z_unit, depth), with notes.
/// Throws Error{invalid_input} where a unit is one of time or not known.
void convert_by_frame(const InputFile& file, FileContents& contents);

/// What a column of that name (without its unit) says about z.
struct HeightColumn {
  bool is_height = false;
  bool depth = false;
  bool time = false;
};
HeightColumn height_column(std::string_view name);

}  // namespace geomesh::geomodel
