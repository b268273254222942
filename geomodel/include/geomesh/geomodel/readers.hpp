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

/// Reads a surface file of any supported format. The coordinates are returned with elevation up (depth is negated and
/// triangles are inverted) and in metres if the file names its unit. Throws Error{usage} if the file cannot be opened,
/// and Error{invalid_input} with file, line and what was expected if it is truncated, empty, inconsistent or of an
/// unknown format, or has NaN or infinite coordinates. Heights that stand for "no value" though no header says so are
/// left out, with a warning that gives value, count and place.
FileContents read_surface_file(const std::filesystem::path& path, const ReadOptions& options = {});

/// Options for reading a well whose file may be a table.
struct WellReading {
  ReadOptions options;
  /// Point of the well at which measured depth is zero, in the coordinate system of the file.
  std::optional<Vec3> head;
  bool head_is_depth = false;  ///< whether z of the well head counts downwards
  double metres = 1;           ///< metres per unit of the coordinates of the well head
};
/// Reads the path of a well: any format with polylines, or a table with x, y, z, a deviation survey (measured depth,
/// inclination, azimuth), or offsets from the well head. Throws as read_surface_file does.
FileContents read_well_file(const std::filesystem::path& path, const WellReading& reading);

/// Contents of a TetGen .poly or .smesh file (with its .node file): a PLC that is meshed as it is.
struct PlcFile {
  PiecewiseLinearComplex plc;
  std::vector<std::string> region_names;  ///< name of each region seed of the PLC by its id: "region_<attribute>"
  std::vector<int> facet_markers;         ///< boundary marker of each facet, 0 if it has none
  std::vector<std::string> warnings;
};
bool is_plc_file(const std::filesystem::path& path);
PlcFile read_plc_file(const std::filesystem::path& path);

}  // namespace geomesh::geomodel
