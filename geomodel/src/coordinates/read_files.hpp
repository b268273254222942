// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads the files of the surfaces and wells of a project, each file once.
#pragma once

#include <deque>
#include <map>

#include "coordinates/georeference.hpp"
#include "geomesh/core/run_context.hpp"

namespace geomesh::geomodel {

struct ReadFiles {
  /// Contents of the files of all surfaces in the project's order, followed by those of the wells.
  std::vector<FileContents> contents;
  std::vector<SourceInput> sources;  ///< inputs whose coordinates must be converted to the frame of the model
  std::vector<std::string> notes;    ///< of level sets
  std::map<std::size_t, std::vector<FieldPart>> field_parts;  ///< LevelSurfaces::parts
  std::vector<std::string> warnings;      ///< warnings of the readers, preceded by the name of the surface or well
  std::deque<SourceSpec> of_thicknesses;  ///< coordinate settings of thickness files, to which `sources` points
};

/// Reads the files of a project's surfaces and wells. Throws as the readers do.
ReadFiles read_files(const Project& project, const RunContext& context);

}  // namespace geomesh::geomodel
