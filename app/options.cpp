// SPDX-License-Identifier: GPL-3.0-or-later
#include "options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>

#include "geomesh/geomodel/formats.hpp"
#include "geomesh/geomodel/init.hpp"
#include "geomesh/geomodel/words.hpp"
#include "help_format.hpp"
#include "output_flags.hpp"
#include "refinement_flags.hpp"

namespace geomesh::app {
namespace {

const char* const overview = R"(geomesh: tetrahedral meshes of earth models, from surfaces that disagree.

  geomesh PROJECT.yaml               mesh a project: rock units, faults, boundaries and wells named
  geomesh mesh INPUT... -o OUT       mesh surface or PLC files, no project
  geomesh delaunay POINTS -o OUT     Delaunay tetrahedralization of points
  geomesh check MESH                 exact verification of a mesh, of any tool's
  geomesh convert MESH -o OUT        a mesh in another format, of any tool's; sets are kept
  geomesh info FILE                  what a file holds, and what is wrong with it
  geomesh init DIR                   a commented project that runs as it is
  geomesh picture MESH -o NAME.png   a picture of a mesh, or of a project's
  geomesh ensemble STUDY.yaml        many realisations of a project whose surfaces are uncertain

Each has its own help: geomesh mesh --help, or geomesh --help-project for the first. -V prints the version.
Exit status: 0 done, 1 a bug of geomesh, 2 command line or project file, 3 bad input data or faults found by check,
4 cannot be meshed as asked, 130 and 143 interrupted. An output file is complete or absent.
)";

struct Common {
  unsigned threads = 0;
  bool quiet = false, verbose = false, json_progress = false;
  std::string report;

  void add_to(CLI::App& app) {
    app.add_option("--threads", threads, "Number of threads (default: all cores); the result is the same")
        ->check(CLI::Range(1u, 1024u));
    auto* q = app.add_flag("-q,--quiet", quiet, "Print warnings and errors only");
    app.add_flag("-v,--verbose", verbose,
                 "Print details: every message of the stages, every warning, every region, the shapes")
        ->excludes(q);
    app.add_flag("--json-progress", json_progress,
                 "Progress for programs: JSON objects on the standard error, one a line");
    app.add_option("--report", report, "Write a report (JSON) to this file")->type_name("FILE");
  }
  void apply(CommandLine& line) const {
    line.threads = threads;
    line.json_progress = json_progress;
    line.verbosity = quiet ? Verbosity::quiet : verbose ? Verbosity::verbose : Verbosity::normal;
  }
  std::optional<std::filesystem::path> report_file() const {
    if (report.empty()) return std::nullopt;
    return std::filesystem::path(report);
  }
};

[[noreturn]] void usage_error(const std::string& message) { throw Error(ErrorKind::usage, message); }

double parse_number(std::string_view text, const std::string& what) {
  double value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    usage_error(what + ": expected a number, found \"" + std::string(text) + "\"");
  return value;
}

Box3 parse_box(const std::string& text) {
  std::vector<double> values;
  for (std::string_view rest = text;;) {
    const auto comma = rest.find(',');
    values.push_back(parse_number(rest.substr(0, comma), "--box"));
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 1);
  }
  if (values.size() != 6)
    usage_error("--box: expected six numbers x0,y0,z0,x1,y1,z1, found " + std::to_string(values.size()));
  const Box3 box{{values[0], values[1], values[2]}, {values[3], values[4], values[5]}};
  for (std::size_t i = 0; i < 3; ++i)
    if (!(box.min[i] < box.max[i]))
      usage_error(std::string("--box: the smaller ") + "xyz"[i] + " must come first, and differ from the larger");
  return box;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

void check_file_exists(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found)
    usage_error("no such file: " + file.string() + geomodel::file_was_meant(file));
  if (status.type() == std::filesystem::file_type::none) usage_error(file.string() + ": " + error.message());
  if (std::filesystem::is_directory(status)) usage_error(file.string() + " is a folder, not a file");
  if (!std::filesystem::is_regular_file(status))
    usage_error(file.string() + " is a pipe or a device, which may never end; save its content to a file first");
}

void check_stage(const std::string& stage) {
  const auto& names = geomodel::stage_names();
  if (stage.empty() || std::find(names.begin(), names.end(), stage) != names.end()) return;
  const std::string meant = geomodel::was_meant(stage, {names.begin(), names.end()});
  usage_error("--stop-after " + stage + ": no such stage" + (meant.empty() ? ";" : meant) + " stages are " +
              joined(names));
}

/// Throws Error{usage} for the first word that looks like an option and is not an option of the command.
void check_option_names(const CLI::App& app) {
  for (const std::string& word : app.remaining()) {
    if (word.size() < 2 || word[0] != '-') continue;
    std::vector<std::string> known;
    for (const CLI::Option* option : app.get_options())
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    const std::string name = word.substr(0, word.find('='));
    usage_error(name + ": no such option" + geomodel::was_meant(name, {known.begin(), known.end()}) + "\nSee " +
                app.get_name() + " --help");
  }
}

/// Runs CLI11 with the errors of geomesh. Returns true if help was requested (its text is then in `help`).
bool parse(CLI::App& app, int argc, const char* const* argv, std::string& help) {
  use_plain_help(app);
  try {
    app.parse(argc, argv);
    return false;
  } catch (const CLI::CallForHelp&) {
    help = app.help();
    return true;
  } catch (const CLI::ParseError& error) {
    // Misspelt options are reported first, because they cause other errors, such as values taken for files.
    check_option_names(app);
    usage_error(std::string(error.what()) + "\nSee " + app.get_name() + " --help");
  }
}

CommandLine parse_project(int argc, const char* const* argv) {
  CLI::App app("Mesh a project: read its surfaces, intersect them, mesh, verify and write.", "geomesh");
  Common common;
  std::string project, directory, stop_after, help;
  bool preview = false;
  app.add_option("PROJECT.yaml", project, "The project file (docs/project-file.md)")->required();
  app.add_option("-o", directory, "Output folder (default: the project's output.directory)")->type_name("DIR");
  app.add_option("--stop-after", stop_after,
                 "Stop after this stage (intersect writes the soup and its offending spots for viewing)")
      ->type_name("STAGE");
  app.add_flag("--preview", preview,
               "A coarse mesh in seconds (about 10,000 elements, the same names), whatever the project asks");
  common.add_to(app);
  CommandLine line;
  if (parse(app, argc, argv, help)) {
    line.command = Help{help};
    return line;
  }
  check_stage(stop_after);
  check_file_exists(project);
  common.apply(line);
  ProjectCommand command{project, std::nullopt, common.report_file(), stop_after, preview};
  if (!directory.empty()) command.directory = directory;
  line.command = command;
  return line;
}

CommandLine parse_mesh(int argc, const char* const* argv) {
  CLI::App app("Mesh surfaces or a PLC: OFF, OBJ, STL, PLY, VTP, GOCAD .ts/.ml, TetGen .poly/.smesh.", "geomesh mesh");
  Common common;
  std::vector<std::string> inputs;
  std::string output, mode = "constrained", intersect = "auto", box, stop_after, help;
  RefinementFlags refinement;
  bool no_refine = false, preserve = false;
  geomodel::MeshRequest request;
  app.add_option("INPUT", inputs, "Surface files, or one PLC file")->required();
  app.add_option("-o", output,
                 "Output: OUT.vtu (mesh, faces, curves, report), or another extension for that file alone")
      ->required()
      ->type_name("OUT");
  app.add_option("--mode", mode, "constrained: fewest added points; conforming: Delaunay by added points")
      ->check(CLI::IsMember({"constrained", "conforming"}))
      ->capture_default_str();
  app.add_option("--intersect", intersect, "auto: resolve crossings and warn; always: resolve; never: refuse crossings")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
  app.add_flag("--no-refine", no_refine,
               "Add only the points that recovery needs (the default without the options below)");
  app.add_flag("--preserve-boundary", preserve, "No added point on any surface or segment, only inside");
  app.add_flag("--hull", request.keep_hull, "Keep the convex hull, as region \"hull\" where nothing else encloses it");
  app.add_option("--merge-within", request.tolerance,
                 "Merge points, edges and facets nearer to each other than this; 0: only what is equal")
      ->check(CLI::NonNegativeNumber)
      ->type_name("L");
  app.add_option("--box", box, "Cut by a box and mesh its inside")->type_name("x0,y0,z0,x1,y1,z1");
  refinement.add_to(app);
  app.add_option("--stop-after", stop_after, "Stop after this stage")->type_name("STAGE");
  common.add_to(app);
  CommandLine line;
  if (parse(app, argc, argv, help)) {
    line.command = Help{help};
    return line;
  }
  check_stage(stop_after);
  geomodel::format_name_of(output);  // throws an error if the extension of the output is unknown
  for (const std::string& input : inputs) {
    check_file_exists(input);
    request.inputs.emplace_back(input);
  }
  request.output = output;
  request.options.recover.mode = mode == "conforming" ? MeshMode::conforming : MeshMode::constrained;
  request.options.recover.preserve_boundary = preserve;
  using Intersect = geomodel::MeshRequest::Intersect;
  request.intersect = intersect == "never"    ? Intersect::never
                      : intersect == "always" ? Intersect::always
                                              : Intersect::automatic;
  if (!box.empty()) request.box = parse_box(box);
  request.refinement = refinement.settings();
  if (no_refine && request.refinement.refine)
    usage_error("--no-refine contradicts the options that request sizes or quality");
  const std::string contradiction = geomodel::contradiction(request.refinement, request.options.recover);
  if (!contradiction.empty()) usage_error(contradiction);
  request.report = common.report_file();
  request.stop_after = stop_after;
  common.apply(line);
  line.command = request;
  return line;
}

CommandLine parse_delaunay(int argc, const char* const* argv) {
  CLI::App app("Delaunay tetrahedralization of points.", "geomesh delaunay");
  Common common;
  std::string points, output, algorithm = "cavity", cluster = "auto", help;
  app.add_option("POINTS", points, "Lines of x y z (blanks or commas, a header line allowed), or a surface file")
      ->required();
  app.add_option("-o", output, "Output file")->required()->type_name("OUT");
  app.add_option("--algorithm", algorithm, "cavity or flip: the result is the same")
      ->check(CLI::IsMember({"cavity", "flip"}))
      ->capture_default_str();
  app.add_option("--cluster-distance", cluster,
                 "Points nearer than this to an inserted one wait until the end: auto, or a length")
      ->capture_default_str();
  common.add_to(app);
  CommandLine line;
  if (parse(app, argc, argv, help)) {
    line.command = Help{help};
    return line;
  }
  check_file_exists(points);
  geomodel::format_name_of(output);  // throws an error if the extension of the output is unknown
  geomodel::DelaunayRequest request;
  request.points = points;
  request.output = output;
  request.options.algorithm = algorithm == "flip" ? DelaunayAlgorithm::flip : DelaunayAlgorithm::cavity;
  if (cluster != "auto") {
    request.options.cluster_distance = parse_number(cluster, "--cluster-distance");
    if (request.options.cluster_distance < 0) usage_error("--cluster-distance: a length cannot be negative");
  }
  request.report = common.report_file();
  common.apply(line);
  line.command = request;
  return line;
}

CommandLine parse_check(int argc, const char* const* argv) {
  CLI::App app("Verify a mesh exactly: any tool's. Exit 0 where it passes, 3 where it does not.", "geomesh check");
  Common common;
  std::string mesh, project, help;
  std::vector<std::string> surfaces;
  CheckCommand command;
  app.add_option("MESH", mesh, "The mesh: .vtu, .vtk, .msh, .inp, .e, .med, .mesh")->required();
  auto* p = app.add_option("--project", project, "Check against this project's box and surfaces")->type_name("P");
  app.add_option("--surfaces", surfaces, "Check that these surfaces are covered by mesh faces")
      ->type_name("FILE...")
      ->excludes(p);
  app.add_flag("--delaunay", command.delaunay, "Check that the mesh is (constrained) Delaunay");
  app.add_flag("--solver", command.solver,
               "Check what solvers will make of the mesh: volumes, edges, angles, time step");
  app.add_option("--within", command.within,
                 "Surfaces may lie this far off the input, both ways (default: the project's tolerance where it has "
                 "one, else 0)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("L");
  app.add_option("--displacement", command.displacement,
                 "Rounding may have moved points this far (default: 1024 units in the last place of the largest "
                 "coordinate)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("L");
  common.add_to(app);
  CommandLine line;
  if (parse(app, argc, argv, help)) {
    line.command = Help{help};
    return line;
  }
  check_file_exists(mesh);
  if (!project.empty()) check_file_exists(project);
  for (const std::string& surface : surfaces) {
    check_file_exists(surface);
    command.surfaces.emplace_back(surface);
  }
  command.mesh = mesh;
  command.project = project;
  command.report = common.report_file();
  common.apply(line);
  line.command = command;
  return line;
}

CommandLine parse_convert(int argc, const char* const* argv) {
  CLI::App app("Write a mesh in another format; regions, surfaces, curves and node sets are kept.", "geomesh convert");
  Common common;
  OutputFlags flags;
  std::string mesh, output, help;
  app.add_option("MESH", mesh, "The mesh: .vtu, .msh, .inp, .e, .med, .mesh")->required();
  app.add_option("-o", output, "Output; its extension says the format")->required()->type_name("OUT");
  flags.add_to(app);
  common.add_to(app);
  CommandLine line;
  if (parse(app, argc, argv, help)) {
    line.command = Help{help};
    return line;
  }
  check_file_exists(mesh);
  common.apply(line);
  line.command = ConvertCommand{mesh, output, flags.format_of(output), flags.options(), !flags.tells_order()};
  return line;
}

CommandLine parse_info(int argc, const char* const* argv) {
  CLI::App app("Describe what a surface, grid, model or mesh file contains, and what is wrong with it.",
               "geomesh info");
  Common common;
  std::string file, help;
  app.add_option("FILE", file, "Any file that geomesh reads")->required();
  common.add_to(app);
  CommandLine line;
  if (parse(app, argc, argv, help)) {
    line.command = Help{help};
    return line;
  }
  check_file_exists(file);
  common.apply(line);
  line.command = InfoCommand{file, common.report_file()};
  return line;
}

CommandLine parse_init(int argc, const char* const* argv) {
  CLI::App app("Make a folder with a commented project that runs as it is.", "geomesh init");
  Common common;
  std::string directory, template_name = "layers", help;
  app.add_option("DIR", directory, "The folder to make; it must not hold a project yet")->required();
  app.add_option("--template", template_name, "Which template: " + joined(geomodel::template_names()))
      ->capture_default_str()
      ->type_name("NAME");
  common.add_to(app);
  CommandLine line;
  if (parse(app, argc, argv, help)) {
    line.command = Help{help};
    return line;
  }
  common.apply(line);
  line.command = InitCommand{directory, template_name};
  return line;
}

/// Parses `geomesh picture`. The first word that is neither an option nor an option's value is the input.
CommandLine parse_picture(int argc, const char* const* argv) {
  PictureCommand command;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool flag = word.rfind("--no-", 0) == 0 || word.find('=') != std::string::npos;
    if (word == "--help" || word == "-h") {
      command = {{}, {"--help"}};
      break;
    }
    if (word.size() > 1 && word[0] == '-') {
      command.arguments.push_back(word);
      if (!flag && i + 1 < argc) command.arguments.emplace_back(argv[++i]);
    } else if (command.input.empty()) {
      check_file_exists(word);
      command.input = word;
    } else {
      usage_error(word + ": one mesh or project was expected\nSee geomesh picture --help");
    }
  }
  if (command.input.empty() && command.arguments != std::vector<std::string>{"--help"})
    usage_error("which mesh or project should be drawn?\nSee geomesh picture --help");
  CommandLine line;
  line.command = command;
  return line;
}

CommandLine parse_ensemble(int argc, const char* const* argv) {
  CLI::App app("Mesh many realisations of a project whose surfaces are uncertain, and sum them up.",
               "geomesh ensemble");
  std::string study, directory, only, help;
  unsigned jobs = 0, per_task = 0, missing = 0;
  bool collect = false, slurm = false, retry = false, quiet = false;
  app.add_option("STUDY", study, "The study file (docs/ensemble.md)")->required();
  app.add_option("-o", directory, "Output folder (default: the study's output)")->type_name("DIR");
  app.add_option("--jobs", jobs, "Realisations at a time (default: one a core)")->check(CLI::Range(1u, 4096u));
  app.add_option("--only", only, "Make these realisations alone and no summary: 17, 1-100, or 3,5,9-12")
      ->type_name("INDICES");
  app.add_option("--missing", missing, "Print the realisations that are not there yet, N a line, for GNU parallel")
      ->check(CLI::Range(1u, 1000000u))
      ->type_name("N");
  app.add_flag("--collect", collect, "Make tables, grids and the page from what is there, and no realisation");
  app.add_flag("--slurm", slurm, "Write the scripts of a Slurm array and run nothing");
  app.add_option("--per-task", per_task, "Realisations of one task of the array (default: at most 1,000 tasks)")
      ->check(CLI::Range(1u, 1000000u))
      ->type_name("N");
  app.add_flag("--retry-failed", retry, "Make failed realisations again");
  app.add_flag("-q,--quiet", quiet, "Print warnings and errors only");
  CommandLine line;
  if (parse(app, argc, argv, help)) {
    line.command = Help{help};
    return line;
  }
  check_file_exists(study);
  line.command = EnsembleCommand{{argv + 1, argv + argc}};
  return line;
}

using Commands = std::map<std::string, std::function<CommandLine(int, const char* const*)>>;

/// Throws Error{usage} if the first word resembles a command and is not a file; otherwise it is taken for a project.
void check_is_no_misspelt_command(const std::string& word, const Commands& commands) {
  std::vector<std::string_view> names;
  for (const auto& [name, parse] : commands) names.push_back(name);
  const std::string meant = geomodel::was_meant(word, names);
  std::error_code error;
  if (word[0] == '-' || meant.empty() || std::filesystem::exists(word, error)) return;
  usage_error("no such command or file: " + word + meant);
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  static const Commands commands{{"mesh", parse_mesh},       {"delaunay", parse_delaunay}, {"check", parse_check},
                                 {"convert", parse_convert}, {"info", parse_info},         {"init", parse_init},
                                 {"picture", parse_picture}, {"ensemble", parse_ensemble}};
  CommandLine line;
  if (argc < 2) usage_error(std::string("what should be meshed?\n\n") + overview);
  const std::string first = argv[1];
  if (first == "--help" || first == "-h" || first == "help") {
    line.command = Help{overview};
    return line;
  }
  if (first == "--version" || first == "-V") {
    line.command = Help{"geomesh " GEOMESH_VERSION "\n"};
    return line;
  }
  if (first == "--help-project") {
    const char* const help[] = {argv[0], "--help"};
    return parse_project(2, help);
  }
  const auto command = commands.find(first);
  if (command != commands.end()) return command->second(argc - 1, argv + 1);
  check_is_no_misspelt_command(first, commands);
  return parse_project(argc, argv);
}

}  // namespace geomesh::app
