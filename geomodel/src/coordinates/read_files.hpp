// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The files of a project's surfaces and wells, each read once.
#pragma once

#include <deque>
#include <map>

#include "coordinates/georeference.hpp"
#include "geomesh/core/run_context.hpp"

namespace geomesh::geomodel {

struct ReadFiles {
  std::vector<FileContents> contents;  ///< of the surfaces in the project's order, then of the wells
  std::vector<SourceInput> sources;    ///< those whose coordinates are to be placed
  std::vector<std::string> notes;      ///< of level sets
  std::map<std::size_t, std::vector<FieldPart>> field_parts;  ///< LevelSurfaces::parts
  std::vector<std::string> warnings;                          ///< of the readers, behind the names of the entries
  std::deque<SourceSpec> of_thicknesses;                      ///< what `sources` of thicknesses point to
};

/// Throws as the readers.
ReadFiles read_files(const Project& project, const RunContext& context);

}  // namespace geomesh::geomodel
