// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reading of surface, grid and model files: one format a file under src/readers, chosen by content before extension.
#pragma once

#include <filesystem>
#include <string>

#include "geomesh/core/plc.hpp"
#include "geomesh/geomodel/read_options.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// Reads any supported file. Coordinates come back with elevation up (Depth negated, winding swapped) in the file's own
/// length unit converted to metres where the file names one. Throws Error{usage} where the file cannot be opened.
/// Throws Error{invalid_input} where it is truncated, empty, lying about itself or of no known format; the message has
/// file, line and what was expected; NaN and infinities are refused with their row. Heights that stand for "no value"
/// though no header says so are left out, with a warning that tells value, count and place.
FileContents read_surface_file(const std::filesystem::path& path, const ReadOptions& options = {});

/// What a project says about a well whose file may be a table.
struct WellReading {
  ReadOptions options;
  std::optional<Vec3> head;    ///< where measured depth is zero, in the coordinates in which the file is understood
  bool head_is_depth = false;  ///< z of these counts downwards
  double metres = 1;           ///< per unit of these
};
/// A well's path: any format with polylines, or a table with x, y, z, a deviation survey (measured depth, inclination,
/// azimuth), or offsets from the head. Errors as of read_surface_file.
FileContents read_well_file(const std::filesystem::path& path, const WellReading& reading);

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
