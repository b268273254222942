// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The parsed command line. Parsing throws Error{usage}; `--help` gives a Help command with the text to print.
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
  double within = -1;        ///< largest distance of surfaces from the input; negative: the project's tolerance
  double displacement = -1;  ///< largest displacement of surfaces by rounding; negative: computed from the mesh
  std::optional<std::filesystem::path> report;
};
struct ConvertCommand {
  std::filesystem::path mesh, output;
  std::string format;
  geomodel::WriteOptions options;
  bool keep_order = false;  ///< whether elements are written in the order of the mesh, if the format supports it
};
struct InfoCommand {
  std::filesystem::path file;
  std::optional<std::filesystem::path> report;
};
struct InitCommand {
  std::filesystem::path directory;
  std::string template_name;
};

/// The command `geomesh picture`. Everything except the input is passed to the drawing program unchanged; without input
/// the help of that program is requested.
struct PictureCommand {
  std::filesystem::path input;
  std::vector<std::string> arguments;
};

/// The command `geomesh ensemble`. Its arguments are checked, and passed to the Python package unchanged.
struct EnsembleCommand {
  std::vector<std::string> arguments;
};

struct CommandLine {
  std::variant<Help, ProjectCommand, geomodel::MeshRequest, geomodel::DelaunayRequest, CheckCommand, ConvertCommand,
               InfoCommand, InitCommand, PictureCommand, EnsembleCommand>
      command;
  unsigned threads = 0;
  Verbosity verbosity = Verbosity::normal;
  bool json_progress = false;  ///< whether progress is printed as JSON, one object per line
};

CommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace geomesh::app
