// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "geomesh/geomodel/readers.hpp"
#include "pipeline/prepare.hpp"

namespace geomesh::geomodel {
namespace {

/// The object of the file that the entry means: the only one, or the one of that name.
TriangulatedSurface pick_surface(FileContents& contents, const SurfaceSpec& spec) {
  if (contents.surfaces.empty())
    throw Error(ErrorKind::invalid_input, "surface " + spec.name + ": " + spec.file_as_written + " (" + contents.format +
                                              ") holds no triangulated surface");
  if (contents.surfaces.size() == 1) return std::move(contents.surfaces.front());
  std::string names;
  for (TriangulatedSurface& surface : contents.surfaces) {
    if (surface.name == spec.name) return std::move(surface);
    names += (names.empty() ? "" : ", ") + surface.name;
  }
  throw Error(ErrorKind::invalid_input, "surface " + spec.name + ": " + spec.file_as_written + " holds " +
                                            std::to_string(contents.surfaces.size()) + " surfaces (" + names +
                                            ") and none is called " + spec.name + ": give the entry the name of the one you mean");
}

void subtract(std::vector<Vec3>& points, const Vec3& origin) {
  for (Vec3& p : points) p = p - origin;
}

/// Conversions of the whole project are not offered: what would be read in silence as something else is refused.
void refuse_conversions(const Project& project) {
  const std::string where = project.file.filename().string() + ": crs";
  if (project.crs.horizontal == "geographic")
    throw Error(ErrorKind::usage, where + ".horizontal: geographic coordinates are not offered yet; give surfaces and box in a projected "
                                          "system (utm 32N) or in local metres");
  if (project.crs.depth)
    throw Error(ErrorKind::usage, where + ".z: depth is not offered yet for a whole project; files that say so themselves (ZPOSITIVE "
                                          "Depth) are turned when read");
  if (project.crs.unit != "m")
    throw Error(ErrorKind::usage, where + ".unit: " + project.crs.unit + " is not offered yet for a whole project; files that name their "
                                          "unit are converted to metres when read");
}

/// The volume in the project's coordinates: its bounds, and its corners in the map where it is no box along the axes.
nlohmann::ordered_json describe_volume(const ModelVolume& volume, const Vec3& origin) {
  const Vec3 min = volume.bounds.min + origin, max = volume.bounds.max + origin;
  nlohmann::ordered_json box{{"min", {min.x, min.y, min.z}}, {"max", {max.x, max.y, max.z}}};
  for (std::size_t i = 0; i + 2 < volume.sides.size(); ++i) {  // zmin and zmax are the last
    const Vec3 corner = volume.sides[i].points[0] + origin;
    box["corners"].push_back({corner.x, corner.y});
  }
  return box;
}

std::string describe_input(const Project& project, const PreparedModel& model) {
  nlohmann::ordered_json input;
  input["project"] = project.file.filename().string();
  input["crs"] = {{"horizontal", project.crs.horizontal}, {"z", project.crs.depth ? "depth" : "elevation"}, {"unit", project.crs.unit}};
  if (project.box) input["box"] = describe_volume(model.volume, project.output.origin);
  for (const TriangulatedSurface& s : model.surfaces)
    input["surfaces"].push_back({{"name", s.name},
                                 {"kind", to_string(s.kind)},
                                 {"file", s.file},
                                 {"cuts_all", s.cuts_all},
                                 {"points", s.points.size()},
                                 {"triangles", s.triangles.size()}});
  if (!project.column.empty()) input["column"] = project.column;
  input["mesh"] = {{"mode", project.mesh.options.recover.mode == MeshMode::conforming ? "conforming" : "constrained"},
                   {"refine", project.mesh.refinement.refine ? "default" : "none"},
                   {"preserve_boundary", project.mesh.options.recover.preserve_boundary}};
  input["output"] = {{"formats", project.output.formats},
                     {"origin", {project.output.origin.x, project.output.origin.y, project.output.origin.z}}};
  return input.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

void prepare_project(const Project& project, PreparedModel& model, const RunContext& context) {
  refuse_conversions(project);
  std::vector<Polyline> wells;
  {
    StageScope stage(context, "read");
    std::size_t n_triangles = 0;
    for (const SurfaceSpec& spec : project.surfaces) {
      FileContents contents = read_surface_file(spec.file);
      for (const std::string& text : contents.warnings) warn(model.warnings, context, spec.name + ": " + text);
      TriangulatedSurface surface = pick_surface(contents, spec);
      surface.name = spec.name;
      surface.kind = spec.kind;
      surface.cuts_all = spec.cuts_all;
      surface.ends_model = spec.name == project.rules.topography || spec.name == project.rules.floor;
      surface.file = spec.file_as_written;
      subtract(surface.points, project.output.origin);
      n_triangles += surface.triangles.size();
      model.surfaces.push_back(std::move(surface));
      context.report(model.surfaces.size(), project.surfaces.size());
      context.check_cancelled();
    }
    for (const WellSpec& spec : project.wells) {
      FileContents contents = read_surface_file(spec.file);
      if (contents.polylines.empty())
        throw Error(ErrorKind::invalid_input, "well " + spec.name + ": " + spec.file_as_written + " holds no polyline");
      for (Polyline& line : contents.polylines) {
        line.name = contents.polylines.size() == 1 ? spec.name : spec.name + "_" + line.name;
        subtract(line.points, project.output.origin);
        wells.push_back(std::move(line));
      }
    }
    for (NamedPoint point : project.points) {
      point.point = point.point - project.output.origin;
      model.points.push_back(std::move(point));
    }
    context.note(LogLevel::info, std::to_string(model.surfaces.size()) + " surfaces, " + std::to_string(n_triangles) + " triangles");
  }
  model.naming = project.naming;
  for (NamedPoint& seed : model.naming.seeds) seed.point = seed.point - project.output.origin;
  model.rules = project.rules;
  model.origin = project.output.origin;
  model.options = project.mesh.options;
  model.refinement = project.mesh.refinement;
  ArrangementOptions options;
  options.tolerance = project.tolerance;
  if (project.box) {
    model.volume = make_volume(*project.box, model.surfaces, project.output.origin);
    if (!model.volume.note.empty()) note(model.notes, context, model.volume.note);
    options.box = model.volume.box;
    options.volume = model.volume.sides;
    model.rules.box = model.volume.bounds;
  }
  model.input_json = describe_input(project, model);
  build(model, context);
  intersect(model, wells, options, context);
}

}  // namespace geomesh::geomodel
