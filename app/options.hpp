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
#include "geomesh/geomodel/write_options.hpp"
#include "progress.hpp"

namespace geomesh::app {

struct Help {
  std::string text;
};
struct ProjectCommand {
  std::filesystem::path project;
  std::optional<std::filesystem::path> directory, report;
  std::string stop_after;
  bool preview = false;
};
struct CheckCommand {
  std::filesystem::path mesh, project;
  std::vector<std::filesystem::path> surfaces;
  bool delaunay = false, solver = false;
  double within = -1;        ///< negative: what the project says
  double displacement = -1;  ///< by rounding; negative: what the checker computes
  std::optional<std::filesystem::path> report;
};
struct ConvertCommand {
  std::filesystem::path mesh, output;
  std::string format;
  geomodel::WriteOptions options;
  bool keep_order = false;  ///< elements are of the mesh's order, where the format holds that
};
struct InfoCommand {
  std::filesystem::path file;
  std::optional<std::filesystem::path> report;
};
struct InitCommand {
  std::filesystem::path directory;
  std::string template_name;
};

/// Everything but the input goes to the drawing program as it is; without input its help is asked for.
struct PictureCommand {
  std::filesystem::path input;
  std::vector<std::string> arguments;
};

/// A study of many realisations; the words are checked, and handed on as they are.
struct EnsembleCommand {
  std::vector<std::string> arguments;
};

struct CommandLine {
  std::variant<Help, ProjectCommand, geomodel::MeshRequest, geomodel::DelaunayRequest, CheckCommand, ConvertCommand,
               InfoCommand, InitCommand, PictureCommand, EnsembleCommand>
      command;
  unsigned threads = 0;
  Verbosity verbosity = Verbosity::normal;
  bool json_progress = false;  ///< progress as JSON, one object a line
};

CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace geomesh::app
