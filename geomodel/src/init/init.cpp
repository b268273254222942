// SPDX-License-Identifier: GPL-3.0-or-later
#include "geomesh/geomodel/init.hpp"

#include <cmath>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "init/project_schema.hpp"
#include "init/template_surfaces.hpp"

namespace geomesh::geomodel {
namespace {

struct ProjectTemplate {
  std::string project;
  std::vector<TriangulatedSurface> surfaces;
};

const char* const head = R"(# yaml-language-server: $schema=project.schema.json
# A geomesh project. Run it with:  geomesh project.yaml
# Every key is described in docs/project-file.md, and in project.schema.json: editors with a YAML language server complete and check as
# you type.

# Coordinates: here local metres, z up. For UTM write `horizontal: utm 32N`; for depths positive downwards `z: depth`.
crs: {horizontal: local, z: elevation, unit: m}

# The model volume. Surfaces may reach beyond it: what is outside is cut off.
)";

const char* const tail = R"(
# constrained: fewest added points. conforming: Delaunay, for finite volumes.
mesh: {mode: constrained, refine: none}

# Where the results go, relative to this file, and for which programs: vtu (ParaView), msh (Gmsh), inp (CalculiX, Abaqus),
# html (a page with pictures, for a browser).
output: {directory: out, formats: [vtu, html]}
)";

TriangulatedSurface folded_horizon(const std::string& name, double depth, double amplitude) {
  return height_surface(name, -110.7, 10113.3, -93.9, 8107.1, 24, [=](double x, double y) {
    return -depth + amplitude * std::sin(x / 1700.3) * std::cos(y / 2100.7) + 0.01 * x;
  });
}

ProjectTemplate layers() {
  ProjectTemplate result;
  result.surfaces = {folded_horizon("top_chalk", 1210.3, 120), folded_horizon("base_chalk", 2030.9, 160)};
  result.project = std::string(head) + R"(box: {min: [0, 0, -4000], max: [10000, 8000, 0]}

# The input: one entry a surface. kind is horizon, fault or body.
surfaces:
  - {name: top_chalk, kind: horizon, file: surfaces/top_chalk.ts}
  - {name: base_chalk, kind: horizon, file: surfaces/base_chalk.ts}

# Youngest first: unit, horizon, unit, horizon, ..., unit. The units name the regions of the mesh.
column: [tertiary, top_chalk, chalk, base_chalk, basement]
)" + tail;
  return result;
}

ProjectTemplate faulted() {
  ProjectTemplate result = layers();
  // The main fault crosses the whole model; the splay ends inside it.
  result.surfaces.push_back(sheet_surface("main_fault", {3507.1, -200.3, 103.7}, {1310.9, 8403.7, 0}, {1503.3, 7.1, -4301.9}, 12));
  result.surfaces.push_back(sheet_surface("splay", {6203.3, 1807.9, -613.1}, {610.7, 4203.1, 11.3}, {-707.9, 13.7, -2404.3}, 10));
  result.project = std::string(head) + R"(box: {min: [0, 0, -4000], max: [10000, 8000, 0]}

surfaces:
  - {name: top_chalk, kind: horizon, file: surfaces/top_chalk.ts}
  - {name: base_chalk, kind: horizon, file: surfaces/base_chalk.ts}
  - {name: main_fault, kind: fault, file: surfaces/main_fault.ts}   # crosses the model: cuts each layer in two
  - {name: splay, kind: fault, file: surfaces/splay.ts}             # ends inside: its tip is kept as a curve

# A unit cut by a fault falls into several regions: chalk__1, chalk__2.
column: [tertiary, top_chalk, chalk, base_chalk, basement]
)" + tail;
  return result;
}

ProjectTemplate salt_dome() {
  ProjectTemplate result = layers();
  // A stem that widens to a bulb: the flank under the bulb overhangs.
  result.surfaces.push_back(revolved_surface("salt", 5103.7, 3907.3, -3507.9, -603.1, 24, 32, [](double t) {
    const double bulb = 1300.7 * std::sqrt(std::max(0.0, 1 - std::pow((t - 0.72) / 0.28, 2)));
    const double stem = 620.3 * std::min(1.0, 6 * t);
    return t <= 0.44 || t >= 1 ? stem * (t < 1) : std::max(bulb, t < 0.72 ? stem : 0.0);
  }));
  result.project = std::string(head) + R"(box: {min: [0, 0, -4000], max: [10000, 8000, 0]}

surfaces:
  - {name: top_chalk, kind: horizon, file: surfaces/top_chalk.ts}
  - {name: base_chalk, kind: horizon, file: surfaces/base_chalk.ts}
  # A closed surface. The horizons may run through it: with `cuts: all` (the default for a body) their parts inside are removed.
  - {name: salt, kind: body, file: surfaces/salt.ts, cuts: all}

column: [tertiary, top_chalk, chalk, base_chalk, basement]
)" + tail;
  return result;
}

struct NamedTemplate {
  const char* name;
  ProjectTemplate (*make)();
};
constexpr NamedTemplate templates[] = {{"layers", layers}, {"faulted", faulted}, {"salt-dome", salt_dome}};

}  // namespace

std::vector<std::string> template_names() {
  std::vector<std::string> names;
  for (const NamedTemplate& t : templates) names.emplace_back(t.name);
  return names;
}

std::filesystem::path init_project(const std::filesystem::path& directory, const std::string& template_name) {
  for (const NamedTemplate& candidate : templates) {
    if (candidate.name != template_name) continue;
    const std::filesystem::path project = directory / "project.yaml";
    if (std::filesystem::exists(project))
      throw Error(ErrorKind::usage, project.string() + " is there already: choose another folder, or remove it first");
    const ProjectTemplate content = candidate.make();
    std::filesystem::create_directories(directory / "surfaces");
    for (const TriangulatedSurface& surface : content.surfaces)
      write_text_file(directory / "surfaces" / (surface.name + ".ts"), to_gocad(surface));
    write_text_file(directory / "project.schema.json", project_schema);
    write_text_file(project, content.project);
    return project;
  }
  std::string known;
  for (const std::string& name : template_names()) known += (known.empty() ? "" : ", ") + name;
  throw Error(ErrorKind::usage, "no template \"" + template_name + "\"; known are " + known);
}

}  // namespace geomesh::geomodel
