// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reading of surface, grid and model files: one format a file under src/readers, chosen by content before extension.
#pragma once

#include <filesystem>
#include <string>

#include "geomesh/core/plc.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Reads any supported file. Coordinates come back with elevation up (Depth negated, winding swapped) in the file's own
/// length unit converted to metres where the file names one. Throws Error{usage} where the file cannot be opened.
/// Throws Error{invalid_input} where it is truncated, empty, lying about itself or of no known format; the message has
/// file, line and what was expected; NaN and infinities are refused with their row.
FileContents read_surface_file(const std::filesystem::path& path);

/// TetGen .poly / .smesh (and .node beside it): a PLC as it is.
struct PlcFile {
  PiecewiseLinearComplex plc;
  std::vector<std::string> region_names;  ///< by region seed id: "region_<attribute>"
  std::vector<int> facet_markers;         ///< per facet, 0 where none
  std::vector<std::string> warnings;
};
bool is_plc_file(const std::filesystem::path& path);
PlcFile read_plc_file(const std::filesystem::path& path);

}  // namespace geomesh::geomodel
