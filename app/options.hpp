// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The command line as understood. Parsing throws Error{usage}; `--help` gives a Help command whose text is to be
/// printed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geomesh/geomodel/pipeline.hpp"
#include "progress.hpp"

namespace geomesh::app {

struct Help {
  std::string text;
};
struct ProjectCommand {
  std::filesystem::path project;
  std::optional<std::filesystem::path> directory, report;
  std::string stop_after;
};
struct CheckCommand {
  std::filesystem::path mesh, project;
  std::vector<std::filesystem::path> surfaces;
  bool delaunay = false;
  double within = -1;  ///< negative: what the project says
  std::optional<std::filesystem::path> report;
};
struct InfoCommand {
  std::filesystem::path file;
  std::optional<std::filesystem::path> report;
};
struct InitCommand {
  std::filesystem::path directory;
  std::string template_name;
};

struct CommandLine {
  std::variant<Help, ProjectCommand, geomodel::MeshRequest, geomodel::DelaunayRequest, CheckCommand, InfoCommand,
               InitCommand>
      command;
  unsigned threads = 0;
  Verbosity verbosity = Verbosity::normal;
};

CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace geomesh::app
