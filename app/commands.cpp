// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>

#include "colours.hpp"
#include "ensemble_command.hpp"
#include "file_words.hpp"
#include "geomesh/geomodel/check.hpp"
#include "geomesh/geomodel/formats.hpp"
#include "geomesh/geomodel/info.hpp"
#include "geomesh/geomodel/init.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "picture_command.hpp"
#include "signals.hpp"

namespace geomesh::app {
namespace {

constexpr int status_faults_found = 3;

/// Lists written files; those with the same stem are on one line: "out/salt.vtu, .faces.vtp, .report.json".
std::vector<std::string> file_lines(const std::vector<std::filesystem::path>& files) {
  std::vector<std::string> lines;
  std::string stem;
  for (const std::filesystem::path& file : files) {
    const std::string name = file.string();
    if (!stem.empty() && name.starts_with(stem + ".")) {
      lines.back() += ", " + name.substr(stem.size());
    } else {
      stem = (file.parent_path() / file.stem()).string();
      lines.push_back(name);
    }
  }
  return lines;
}

/// Colours the two verdicts about model and mesh: green if nothing is wrong, else yellow. Other lines are unchanged.
std::string verdict_painted(const std::string& text) {
  const Colours colours = Colours::of(STDOUT_FILENO);
  if (text.find(" about the model") != std::string::npos) {
    const bool is_whole = text.starts_with("all ") || text.starts_with("the unit ");
    return is_whole && text.ends_with("; no warnings about the model") ? colours.good(text) : colours.warning(text);
  }
  if (text.find("fit for solvers") == std::string::npos) return text;
  return text.starts_with("not ") || text.find("warning") != std::string::npos ? colours.warning(text)
                                                                               : colours.good(text);
}

/// Prints how to view the result: the page for a browser, and the command that draws a picture.
void tell_how_to_look(const std::vector<std::filesystem::path>& files) {
  const auto named = [&](const char* end) {
    return std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.string().ends_with(end); });
  };
  std::string text;
  if (const auto page = named(".html"); page != files.end()) text = "open " + file_address(*page);
  if (const auto mesh = named(".vtu"); mesh != files.end()) {
    std::filesystem::path picture = *mesh;
    text += (text.empty() ? "picture: " : "   picture: ") + ("geomesh picture " + shell_word(*mesh)) + " -o " +
            shell_word(picture.replace_extension(".png"));
  }
  if (!text.empty()) std::cout << text << '\n';
}

void print_result(const geomodel::JobResult& result, Verbosity verbosity) {
  if (verbosity == Verbosity::quiet) return;
  for (const std::string& text : result.summary) std::cout << verdict_painted(text) << '\n';
  if (verbosity == Verbosity::verbose)
    for (const std::string& text : result.details) std::cout << text << '\n';
  for (const std::string& text : file_lines(result.files)) std::cout << "wrote " << text << '\n';
  tell_how_to_look(result.files);
}

/// Writes the report of a command that only reads files (check, info), if one is requested.
void write_report(const std::optional<std::filesystem::path>& file, const std::string& text) {
  if (!file) return;
  const SignalsHeldBack held;
  geomodel::write_text_file(*file, text);
}

int run_command(const Help& help, const RunContext&, Verbosity) {
  std::cout << help.text;
  return 0;
}

int run_command(const ProjectCommand& command, const RunContext& context, Verbosity verbosity) {
  geomodel::ProjectRequest request;
  request.preview = command.preview;
  request.project = geomodel::read_project(command.project);
  request.directory = command.directory;
  request.report = command.report;
  request.stop_after = command.stop_after;
  print_result(geomodel::run_project(request, context), verbosity);
  return 0;
}

int run_command(const geomodel::MeshRequest& request, const RunContext& context, Verbosity verbosity) {
  print_result(geomodel::run_mesh(request, context), verbosity);
  return 0;
}

int run_command(const geomodel::DelaunayRequest& request, const RunContext& context, Verbosity verbosity) {
  print_result(geomodel::run_delaunay(request, context), verbosity);
  return 0;
}

int run_command(const CheckCommand& command, const RunContext&, Verbosity verbosity) {
  leave_at_once_when_signalled();
  if (command.report) geomodel::require_writable(*command.report);
  const geomodel::CheckResult result =
      geomodel::check_mesh({command.mesh, command.project, command.surfaces, command.delaunay, command.solver,
                            command.displacement, command.within});
  write_report(command.report, geomodel::to_json(result));
  if (verbosity != Verbosity::quiet || !result.faults.empty()) std::cout << geomodel::to_text(result);
  return result.faults.empty() ? 0 : status_faults_found;
}

int run_command(const ConvertCommand& command, const RunContext&, Verbosity verbosity) {
  const std::filesystem::path stem = command.output.parent_path() / command.output.stem();
  geomodel::ElementOrder order = geomodel::ElementOrder::first;
  const geomodel::ModelMesh mesh = geomodel::read_model_mesh(command.mesh, &order);
  geomodel::WriteOptions options = command.options;
  const geomodel::Format* const format = geomodel::format_of_name(command.format);
  if (!format)
    throw Error(ErrorKind::usage, "a page (.html) is written by the run that makes the mesh, not from a mesh file");
  const bool is_kept = format->holds.second_order && !options.cohesive;
  if (command.keep_order && is_kept) options.order = order;
  const SignalsHeldBack held;
  if (!stem.parent_path().empty()) std::filesystem::create_directories(stem.parent_path());
  geomodel::JobResult result;
  result.files = geomodel::write_format(mesh, command.format, stem, options);
  result.summary.push_back(std::to_string(mesh.tetrahedra.size()) + " tetrahedra, " +
                           std::to_string(mesh.regions.size()) + " regions, " + std::to_string(mesh.surfaces.size()) +
                           " surfaces, " + std::to_string(mesh.curves.size() + mesh.marked_points.size()) +
                           " curves and points, " + std::to_string(mesh.node_sets.size()) + " other node sets");
  if (order == geomodel::ElementOrder::second && options.order == geomodel::ElementOrder::first)
    result.summary.push_back(
        "elements of second order are written in first order: nodes in the middle of edges are left out");
  print_result(result, verbosity);
  return 0;
}

int run_command(const InfoCommand& command, const RunContext&, Verbosity) {
  leave_at_once_when_signalled();
  if (command.report) geomodel::require_writable(*command.report);
  const geomodel::FileInfo info = geomodel::describe_file(command.file);
  write_report(command.report, geomodel::to_json(info));
  std::cout << geomodel::to_text(info);
  return 0;
}

int run_command(const InitCommand& command, const RunContext&, Verbosity verbosity) {
  const auto project = geomodel::init_project(command.directory, command.template_name);
  if (verbosity != Verbosity::quiet)
    std::cout << "wrote " << project.string() << "\nNow run: geomesh " << project.string() << '\n';
  return 0;
}

int run_command(const PictureCommand& command, const RunContext& context, Verbosity) {
  return draw_picture(command, context);
}

int run_command(const EnsembleCommand& command, const RunContext&, Verbosity) { run_ensemble(command); }

}  // namespace

int run(const CommandLine& line, const RunContext& context) {
  return std::visit([&](const auto& command) { return run_command(command, context, line.verbosity); }, line.command);
}

}  // namespace geomesh::app
