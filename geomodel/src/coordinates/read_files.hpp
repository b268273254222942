// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Reads the files of a project's surfaces and wells, each once.
#pragma once

#include <deque>
#include <map>

#include "coordinates/georeference.hpp"
#include "geomesh/core/run_context.hpp"

namespace geomesh::geomodel {

struct ReadFiles {
  /// Contents of the surfaces in the project's order, followed by those of the wells.
  std::vector<FileContents> contents;
  std::vector<SourceInput> sources;                           ///< inputs whose coordinates must be converted
  std::vector<std::string> notes;                             ///< of level sets
  std::map<std::size_t, std::vector<FieldPart>> field_parts;  ///< LevelSurfaces::parts
  std::vector<std::string> warnings;      ///< warnings of the readers, preceded by the names of the entries
  std::deque<SourceSpec> of_thicknesses;  ///< targets of the pointers in `sources` of thicknesses
};

/// Throws as the readers.
ReadFiles read_files(const Project& project, const RunContext& context);

}  // namespace geomesh::geomodel
