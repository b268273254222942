// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the stage read of `geomesh mesh`, declared in pipeline/stages/stages.hpp.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "geomesh/geomodel/model_volume.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "geomesh/geomodel/sizes_in_range.hpp"
#include "grid_sizes/size_grid.hpp"
#include "pipeline/stages/hull.hpp"
#include "pipeline/stages/stages.hpp"

namespace geomesh::geomodel {
namespace {

/// Reads a PLC. The first three corners of each facet make a triangle of one surface, so that results can be named.
void read_plc(const std::filesystem::path& path, Inputs& model, Journal& journal) {
  const StageScope stage(journal.context(), "read");
  PlcFile file = read_plc_file(path);
  journal.warn_all(file.warnings);
  TriangulatedSurface surface;
  surface.name = path.stem().string();
  surface.file = path.filename().string();
  surface.points = file.plc.points;
  for (Index f = 0; f < file.plc.n_facets(); ++f) {
    const auto loop = file.plc.outer_loop(f);
    surface.triangles.push_back({loop[0], loop[1], loop[2]});
  }
  model.surfaces.push_back(std::move(surface));
  model.naming.seed_names = file.region_names;
  journal.context().note(LogLevel::info, std::to_string(file.plc.points.size()) + " points, " +
                                             std::to_string(file.plc.n_facets()) + " facets");
  model.plc = std::move(file);
}

void read_surfaces(const MeshRequest& request, Inputs& model, Journal& journal) {
  const RunContext& context = journal.context();
  const StageScope stage(context, "read");
  std::size_t n_triangles = 0;
  for (const auto& path : request.inputs) {
    FileContents contents = read_surface_file(path);
    for (const std::string& text : contents.warnings) journal.warn(path.filename().string() + ": " + text);
    if (contents.surfaces.empty() && contents.polylines.empty() && contents.points.empty())
      throw Error(ErrorKind::invalid_input, path.filename().string() + " (" + contents.format + ") holds no surface");
    const auto first = static_cast<Index>(model.surfaces.size());
    for (RegionHint& hint : contents.regions) {
      for (RegionHint::OrientedTriangle& side : hint.boundary) side.surface += first;
      model.naming.hints.push_back(std::move(hint));
    }
    for (TriangulatedSurface& surface : contents.surfaces) {
      if (surface.name.empty()) surface.name = path.stem().string();
      surface.file = path.filename().string();
      n_triangles += surface.triangles.size();
      model.surfaces.push_back(std::move(surface));
    }
    std::move(contents.polylines.begin(), contents.polylines.end(), std::back_inserter(model.wells));
    std::move(contents.points.begin(), contents.points.end(), std::back_inserter(model.points));
    context.report(model.surfaces.size(), 0);
    context.check_cancelled();
  }
  make_names_unique(model.surfaces);
  context.note(LogLevel::info,
               std::to_string(model.surfaces.size()) + " surfaces, " + std::to_string(n_triangles) + " triangles");
}

std::string describe_input(const MeshRequest& request, const Inputs& model) {
  nlohmann::ordered_json input;
  for (const auto& path : request.inputs) input["files"].push_back(path.filename().string());
  for (const TriangulatedSurface& s : model.surfaces)
    input["surfaces"].push_back(
        {{"name", s.name}, {"file", s.file}, {"points", s.points.size()}, {"triangles", s.triangles.size()}});
  input["mode"] = request.options.recover.mode == MeshMode::conforming ? "conforming" : "constrained";
  input["refine"] = request.refinement.refine;
  return input.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

void make_names_unique(std::vector<TriangulatedSurface>& surfaces) {
  std::set<std::string> taken{"xmin", "xmax", "ymin", "ymax", "zmin", "zmax", hull_name};
  for (TriangulatedSurface& surface : surfaces) {
    std::string name = surface.name;
    for (int n = 2; !taken.insert(name).second; ++n) name = surface.name + "_" + std::to_string(n);
    surface.name = name;
  }
}

Inputs read_mesh_model(const MeshRequest& request, Journal& journal) {
  Inputs model;
  model.command = "mesh";
  model.name = request.output.stem().string();
  model.options = request.options;
  model.refinement = request.refinement;
  load_background(model.refinement.size, model.origin);
  model.naming.name_by_bodies = false;
  if (request.inputs.size() == 1 && is_plc_file(request.inputs.front())) {
    if (request.box || request.keep_hull)
      throw Error(ErrorKind::usage,
                  std::string(request.box ? "--box" : "--hull") + " cannot be combined with a PLC file (" +
                      request.inputs.front().filename().string() +
                      "), which is meshed as it is; give its surfaces as OFF, OBJ, STL, PLY or .ts instead");
    read_plc(request.inputs.front(), model, journal);
    require_sizes_in_range(model.refinement, bounds_of(model.surfaces));
    model.description = describe_input(request, model);
    return model;
  }
  read_surfaces(request, model, journal);
  require_sizes_in_range(model.refinement, request.box ? *request.box : bounds_of(model.surfaces));
  model.description = describe_input(request, model);
  if (request.keep_hull) {
    model.naming.hull_surface = static_cast<Index>(model.surfaces.size());
    model.surfaces.push_back(convex_hull_surface(model.surfaces, journal.context()));
  }
  model.arrangement.box = request.box;
  model.arrangement.tolerance = request.tolerance;
  if (request.intersect == MeshRequest::Intersect::never)
    model.arrangement.crossings = ArrangementOptions::Crossings::refuse;
  model.closed_are_bodies = true;
  return model;
}

}  // namespace geomesh::geomodel
