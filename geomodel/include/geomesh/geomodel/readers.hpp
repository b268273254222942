// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads surface, grid and model files. Each format has one file in src/readers, and is recognised by content before
/// extension.
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
/// though no header says so are left out, with a warning that gives value, count and place.
FileContents read_surface_file(const std::filesystem::path& path, const ReadOptions& options = {});

/// Options for reading a well whose file may be a table.
struct WellReading {
  ReadOptions options;
  std::optional<Vec3> head;    ///< point at which measured depth is zero, in the coordinate system of the file
  bool head_is_depth = false;  ///< whether z of the well head counts downwards
  double metres = 1;           ///< metres per unit of the head's coordinates
};
/// Reads a well's path: any format with polylines, or a table with x, y, z, a deviation survey (measured depth,
/// inclination, azimuth), or offsets from the head. Throws as read_surface_file.
FileContents read_well_file(const std::filesystem::path& path, const WellReading& reading);

/// A TetGen .poly or .smesh file (with its .node file): a PLC that is meshed as it is.
struct PlcFile {
  PiecewiseLinearComplex plc;
  std::vector<std::string> region_names;  ///< names of regions by region seed id: "region_<attribute>"
  std::vector<int> facet_markers;         ///< marker of each facet, 0 if it has none
  std::vector<std::string> warnings;
};
bool is_plc_file(const std::filesystem::path& path);
PlcFile read_plc_file(const std::filesystem::path& path);

}  // namespace geomesh::geomodel
