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
  std::vector<TriangulatedSurface> surfaces;  ///< surfaces of the template, each written to surfaces/NAME.ts
  std::vector<std::pair<std::string, std::string>> files{};  ///< further files of the template: path and content
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
# The mesh: for solvers, of a size derived from the model, with surfaces remeshed within a tolerance that follows the size. More:
# mesh: {size: 400}                    edges of about 400 m
# mesh: {size: 400, honour: exact}     every triangle of the surfaces is kept
# mesh: {refine: none}                 the bare triangulation of the surfaces, no mesh for a solver
# mesh: {mode: conforming, size: 400}  Delaunay, for finite volumes

# Where the results go, relative to this file, and for which programs: vtu (ParaView), msh (Gmsh), inp (CalculiX, Abaqus),
# html (a page with pictures, for a browser).
output: {directory: out, formats: [vtu, html]}
)";

TriangulatedSurface folded_horizon(const std::string& name, double depth, double amplitude, int n = 24) {
  return height_surface(name, {-110.7, 10113.3, -93.9, 8107.1, n}, [=](double x, double y) {
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

/// Returns the horizon displaced along a planar fault: it is lowered by the throw in the hanging wall. The plane is
/// given by a point and two directions, of which the second points down.
TriangulatedSurface thrown_horizon(TriangulatedSurface horizon, const Vec3& through, const Vec3& along,
                                   const Vec3& down, double throw_of_fault) {
  const Vec3 towards_hanging_wall = cross(along, down);
  for (Vec3& p : horizon.points)
    if (dot(towards_hanging_wall, p - through) * towards_hanging_wall.z > 0) p.z -= throw_of_fault;
  return horizon;
}

ProjectTemplate faulted() {
  ProjectTemplate result = layers();
  // Orientation of the main fault, which crosses the whole model; the splay ends inside it.
  const Vec3 through{3507.1, -200.3, 103.7}, along{1310.9, 8403.7, 0}, down{1503.3, 7.1, -4301.9};
  constexpr int fine = 60;  // About ten edges beside the fault are needed to distinguish its throw from a bend.
  result.surfaces = {folded_horizon("top_chalk", 1210.3, 120, fine), folded_horizon("base_chalk", 2030.9, 160, fine)};
  for (TriangulatedSurface& horizon : result.surfaces)
    horizon = thrown_horizon(std::move(horizon), through, along, down, 151.3);
  result.surfaces.push_back(sheet_surface("main_fault", through, along, down, 12));
  result.files = {
      {"wells/well_1.pl",
       to_gocad(Polyline{"well_1", "", {{7503.1, 5207.3, 0}, {7503.1, 5207.3, -1403.9}, {7907.7, 5511.1, -2608.3}}})}};
  result.surfaces.push_back(
      sheet_surface("splay", {6203.3, 1807.9, -613.1}, {610.7, 4203.1, 11.3}, {-707.9, 13.7, -2404.3}, 10));
  result.project = std::string(head) + R"(box: {min: [0, 0, -4000], max: [10000, 8000, 0]}

# The horizons were gridded across the main fault, so that its throw is a ramp in them. throw_at makes it a clean offset; with
# throw_at: auto the faults are found.
surfaces:
  - {name: top_chalk, kind: horizon, file: surfaces/top_chalk.ts, throw_at: [main_fault]}
  - {name: base_chalk, kind: horizon, file: surfaces/base_chalk.ts, throw_at: [main_fault]}
  - {name: main_fault, kind: fault, file: surfaces/main_fault.ts}   # crosses the model: cuts each layer in two
  - {name: splay, kind: fault, file: surfaces/splay.ts}             # ends inside: its tip is kept as a curve

# A well path becomes a curve of the mesh.
wells:
  - {name: well_1, file: wells/well_1.pl}

# A unit cut by a fault falls into several regions: chalk__1, chalk__2.
column: [tertiary, top_chalk, chalk, base_chalk, basement]
)" + tail;
  return result;
}

ProjectTemplate salt_dome() {
  ProjectTemplate result = layers();
  // The body of salt is a stem that widens to a bulb, so that the flank under the bulb overhangs.
  result.surfaces.push_back(revolved_surface("salt", {5103.7, 3907.3, -3507.9, -603.1, 24, 32}, [](double t) {
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

/// Returns a project with data as exported from GOCAD or SKUA, with several objects in one file. Horizons end before
/// the box, one has a hole, and one is given separately for each fault block.
ProjectTemplate from_gocad() {
  ProjectTemplate result;
  const double throw_of_fault = 180;
  TriangulatedSurface top =
      height_surface("top_reservoir", {611.3, 9402.7, 518.9, 7388.3, 20}, [&](double x, double y) {
        return -1500 + 60 * std::sin(x / 1900.3) - 0.02 * y - (x > 5000 ? throw_of_fault : 0);
      });
  // The horizon has separate blocks, because it was not interpreted between x = 4,800 and 5,350 m.
  std::erase_if(top.triangles, [&](const Triangle& t) {
    const double x = (top.points[t[0]].x + top.points[t[1]].x + top.points[t[2]].x) / 3;
    return x > 4800 && x < 5350;
  });
  TriangulatedSurface base = height_surface("base_cover", {402.1, 9588.9, 390.3, 7607.7, 18}, [](double x, double y) {
    return -700 + 0.015 * x + 40 * std::cos(y / 1500.7);
  });
  std::erase_if(base.triangles, [&](const Triangle& t) {
    const Vec3& p = base.points[t[0]];
    return p.x > 2500 && p.x < 3200 && p.y > 3000 && p.y < 3900;
  });
  const TriangulatedSurface fault =
      sheet_surface("fault_a", {5160.3, 260.7, -1010.3}, {211.9, 7503.1, 3.7}, {-203.3, 9.1, -1702.9}, 8);
  result.files = {
      {"surfaces/horizons.ts", to_gocad(base) + to_gocad(top)},
      {"surfaces/fault_a.ts", to_gocad(fault)},
      {"wells/well_1.pl",
       to_gocad(Polyline{"well_1", "", {{3007.3, 4004.9, 0}, {3007.3, 4004.9, -1203.1}, {3406.7, 4211.3, -2107.9}}})}};
  result.project =
      std::string(head) +
      R"(# Here: about the data, with 300 m more on each side in the map, from -3000 m up to the surface of the ground.
box: {margin: [300, 300, 0], bottom: -3000, top: 0}

surfaces:
  # Several objects in one file: the name tells which one is meant. It stops short of the box and has a hole.
  - {name: base_cover, kind: horizon, file: surfaces/horizons.ts, extend: tangent, fill_holes: all}
  # Interpreted block by block; neither block reaches the fault. Each is continued on its own and ends on it.
  - {name: top_reservoir, kind: horizon, file: surfaces/horizons.ts, extend: tangent, throw_at: [fault_a]}
  # Stops short above, below and on both sides: continued through the box, but it cuts nothing above base_cover.
  - {name: fault_a, kind: fault, file: surfaces/fault_a.ts, extent: to_box, cuts: [overburden, reservoir]}

# A well path becomes a curve of the mesh.
wells:
  - {name: well_1, file: wells/well_1.pl}

# The fault divides two units: overburden__1, overburden__2, reservoir__1, reservoir__2, numbered by place.
column: [cover, base_cover, overburden, top_reservoir, reservoir]

# Numbers that go with the units into the mesh.
attributes:
  reservoir: {porosity: 0.22, permeability: 1.2e-13}
  overburden: {porosity: 0.08, permeability: 1.0e-17}
)" + tail;
  return result;
}

ProjectTemplate topography_and_wells() {
  ProjectTemplate result;
  result.surfaces = {height_surface("relief", {-120.3, 6130.7, -110.9, 5107.3, 30},
                                    [](double x, double y) {
                                      return 420 + 160 * std::sin(x / 800.7 + 0.3) * std::cos(y / 900.1) + 0.02 * y;
                                    }),
                     height_surface("base_gravel", {-130.7, 6140.3, -120.1, 5130.9, 16},
                                    [](double x, double y) { return 300 + 0.03 * x - 0.01 * y; }),
                     height_surface("top_bedrock", {-140.9, 6150.1, -130.3, 5140.7, 16},
                                    [](double x, double y) { return 60 + 30 * std::sin(x / 1300.9) + 0.01 * y; })};
  result.files = {
      {"wells/water_well.pl", to_gocad(Polyline{"water_well", "", {{2011.3, 2503.9, 900}, {2011.3, 2503.9, 120.7}}})},
      {"wells/probe.pl",
       to_gocad(Polyline{"probe", "", {{4203.7, 1207.1, 900}, {4203.7, 1207.1, 40.3}, {4603.1, 1510.9, -310.7}}})}};
  result.project =
      std::string(head) + R"(# Its top is the topography: the mesh ends on it, and layers crop out where it cuts them.
box: {center: [3000, 2500], size: [6000, 5000], bottom: -600, top: relief}

surfaces:
  - {name: relief, kind: horizon, file: surfaces/relief.ts}
  - {name: base_gravel, kind: horizon, file: surfaces/base_gravel.ts}
  - {name: top_bedrock, kind: horizon, file: surfaces/top_bedrock.ts}

# Well paths become curves of the mesh; what stands above the ground is left out, with a warning.
wells:
  - {name: water_well, file: wells/water_well.pl}
  - {name: probe, file: wells/probe.pl}

# A vertex of the mesh under a name of its own.
points:
  - {name: gauge, at: [1500, 1000, 150]}

column: [gravel, base_gravel, sandstone, top_bedrock, bedrock]

# A name for several units together.
groups:
  aquifer: [gravel, sandstone]
)" + tail;
  return result;
}

struct NamedTemplate {
  const char* name;
  ProjectTemplate (*make)();
};
constexpr NamedTemplate templates[] = {{"layers", layers},
                                       {"faulted", faulted},
                                       {"salt-dome", salt_dome},
                                       {"from-gocad", from_gocad},
                                       {"topography-and-wells", topography_and_wells}};

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
    for (const auto& [path, text] : content.files) {
      std::filesystem::create_directories((directory / path).parent_path());
      write_text_file(directory / path, text);
    }
    write_text_file(directory / "project.schema.json", project_schema);
    write_text_file(project, content.project);
    return project;
  }
  std::string known;
  for (const std::string& name : template_names()) known += (known.empty() ? "" : ", ") + name;
  throw Error(ErrorKind::usage, "no template \"" + template_name + "\"; known are " + known);
}

}  // namespace geomesh::geomodel
