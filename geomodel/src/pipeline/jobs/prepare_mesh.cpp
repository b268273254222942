// SPDX-License-Identifier: GPL-3.0-or-later
// The model of `geomesh mesh`, declared in pipeline/jobs/prepare.hpp.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "geomesh/geomodel/model_volume.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "geomesh/geomodel/sizes_in_range.hpp"
#include "grid_sizes/size_grid.hpp"
#include "pipeline/jobs/hull.hpp"
#include "pipeline/jobs/prepare.hpp"

namespace geomesh::geomodel {
namespace {

/// True where every edge (by coordinates of its ends) has an even number of triangles.
bool is_closed(const TriangulatedSurface& surface) {
  const auto less = [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); };
  std::map<Vec3, Index, decltype(less)> ids(less);
  std::vector<std::pair<Index, Index>> edges;
  for (const Triangle& t : surface.triangles)
    for (int i = 0; i < 3; ++i) {
      const auto id = [&](VertexIndex v) {
        return ids.try_emplace(surface.points[v], static_cast<Index>(ids.size())).first->second;
      };
      const Index a = id(t[i]), b = id(t[(i + 1) % 3]);
      if (a != b) edges.emplace_back(std::min(a, b), std::max(a, b));
    }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t j = i;
    while (j < edges.size() && edges[j] == edges[i]) ++j;
    if ((j - i) % 2 != 0) return false;
    i = j;
  }
  return !edges.empty();
}

/// A PLC file becomes the engine's input as it is; its facets stand in for soup facets so that results can be named.
void prepare_plc(const std::filesystem::path& path, PreparedModel& model, const RunContext& context) {
  StageScope stage(context, "read");
  PlcFile file = read_plc_file(path);
  for (const std::string& text : file.warnings) warn(model.warnings, context, text);
  TriangulatedSurface surface;
  surface.name = path.stem().string();
  surface.file = path.filename().string();
  surface.points = file.plc.points;
  PolygonSoup& soup = model.arrangement.soup;
  soup.points = file.plc.points;
  soup.kind.assign(soup.points.size(), SoupVertexKind::input);
  for (Index v = 0; v < soup.points.size(); ++v) soup.input_point.push_back(v);
  for (Index f = 0; f < file.plc.n_facets(); ++f) {
    const auto loop = file.plc.outer_loop(f);
    surface.triangles.push_back({loop[0], loop[1], loop[2]});
    soup.facets.push_back(surface.triangles.back());
    soup.origins.push_back({0, f, false});
    soup.origin_offsets.push_back(static_cast<Index>(soup.origins.size()));
    model.plc.facet_soup.push_back(f);
    model.plc.facet_soup_offsets.push_back(f + 1);
  }
  model.surfaces.push_back(std::move(surface));
  model.plc.facet_patch.assign(file.plc.n_facets(), 1);
  model.plc.segment_curves.resize(file.plc.segments.size());
  model.plc.plc = std::move(file.plc);
  model.naming.seed_names = std::move(file.region_names);
  context.note(LogLevel::info, std::to_string(model.plc.plc.points.size()) + " points, " +
                                   std::to_string(model.plc.plc.n_facets()) + " facets");
}

void read_surfaces(const MeshRequest& request, PreparedModel& model, std::vector<Polyline>& wells,
                   const RunContext& context) {
  StageScope stage(context, "read");
  std::size_t n_triangles = 0;
  for (const auto& path : request.inputs) {
    FileContents contents = read_surface_file(path);
    for (const std::string& text : contents.warnings)
      warn(model.warnings, context, path.filename().string() + ": " + text);
    if (contents.surfaces.empty() && contents.polylines.empty() && contents.points.empty())
      throw Error(ErrorKind::invalid_input, path.filename().string() + " (" + contents.format + ") holds no surface");
    const auto first = static_cast<Index>(model.surfaces.size());
    for (RegionHint& hint : contents.regions) {
      for (RegionHint::Side& side : hint.boundary) side.surface += first;
      model.naming.hints.push_back(std::move(hint));
    }
    for (TriangulatedSurface& surface : contents.surfaces) {
      if (surface.name.empty()) surface.name = path.stem().string();
      surface.file = path.filename().string();
      n_triangles += surface.triangles.size();
      model.surfaces.push_back(std::move(surface));
    }
    std::move(contents.polylines.begin(), contents.polylines.end(), std::back_inserter(wells));
    std::move(contents.points.begin(), contents.points.end(), std::back_inserter(model.points));
    context.report(model.surfaces.size(), 0);
    context.check_cancelled();
  }
  make_names_unique(model.surfaces);
  context.note(LogLevel::info,
               std::to_string(model.surfaces.size()) + " surfaces, " + std::to_string(n_triangles) + " triangles");
}

std::string describe_input(const MeshRequest& request, const PreparedModel& model) {
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

void prepare_mesh(const MeshRequest& request, PreparedModel& model, const RunContext& context) {
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
    prepare_plc(request.inputs.front(), model, context);
    require_sizes_in_range(model.refinement, bounds_of(model.surfaces));
    model.input_json = describe_input(request, model);
    return;
  }
  std::vector<Polyline> wells;
  read_surfaces(request, model, wells, context);
  require_sizes_in_range(model.refinement, request.box ? *request.box : bounds_of(model.surfaces));
  model.input_json = describe_input(request, model);
  if (request.keep_hull) {
    model.naming.hull_surface = static_cast<Index>(model.surfaces.size());
    model.surfaces.push_back(convex_hull_surface(model.surfaces, context));
  }

  ArrangementOptions options;
  options.box = request.box;
  options.tolerance = request.tolerance;
  if (request.intersect == MeshRequest::Intersect::never) options.crossings = ArrangementOptions::Crossings::refuse;
  intersect(model, wells, options, context);
  // Closed surfaces are bodies for `inside`; they do not cut each other.
  for (TriangulatedSurface& surface : model.surfaces)
    if (surface.kind == SurfaceKind::surface && surface.name != hull_name && is_closed(surface))
      surface.kind = SurfaceKind::body;
}

}  // namespace geomesh::geomodel
