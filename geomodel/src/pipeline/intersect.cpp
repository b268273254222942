// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>

#include "pipeline/prepare.hpp"

namespace geomesh::geomodel {
namespace {

/// A surface of which nothing is left is most often one in other coordinates than the box.
void warn_of_absent_surfaces(PreparedModel& model, const RunContext& context) {
  std::vector<bool> present(model.surfaces.size(), false);
  for (const PolygonSoup::Origin& origin : model.arrangement.soup.origins)
    if (origin.surface < present.size()) present[origin.surface] = true;
  for (std::size_t s = 0; s < model.surfaces.size(); ++s) {
    if (present[s] || model.surfaces[s].triangles.empty()) continue;
    Box3 extent;
    for (const Vec3& p : model.surfaces[s].points) extent.add(p);
    char text[200];
    std::snprintf(text, sizeof text, "it reaches from (%.9g, %.9g, %.9g) to (%.9g, %.9g, %.9g)", extent.min.x, extent.min.y,
                  extent.min.z, extent.max.x, extent.max.y, extent.max.z);
    warn(model.warnings, context,
         std::string(to_string(model.surfaces[s].kind)) + " " + model.surfaces[s].name +
             " never meets the model: all of it lies outside the box or inside bodies that cut it; " + text);
  }
}

}  // namespace

void build(PreparedModel& model, const RunContext& context) {
  StageScope stage(context, "build");
  BuiltSurfaces built = build_surfaces(model.surfaces, model.rules);
  model.surfaces = std::move(built.surfaces);
  model.built_rows = std::move(built.rows);
  for (std::string& text : built.notes) note(model.notes, context, std::move(text));
  for (std::string& text : built.warnings) warn(model.warnings, context, std::move(text));
}

void intersect(PreparedModel& model, const std::vector<Polyline>& wells, const ArrangementOptions& options,
               const RunContext& context) {
  StageScope stage(context, "intersect");
  model.arrangement = arrange(model.surfaces, wells, model.points, options, context);
  for (const std::string& text : model.arrangement.warnings) warn(model.warnings, context, text);
  warn_of_absent_surfaces(model, context);
  for (const TriangulatedSurface& side : model.arrangement.box_sides) model.surfaces.push_back(side);
  if (model.rules.trims()) {
    TrimmedSoup trimmed = trim_soup(model.arrangement.soup, model.surfaces, model.built_rows, model.rules);
    model.arrangement.soup = std::move(trimmed.soup);
    model.arrangement.area_clipped_by_rules = std::move(trimmed.area_removed);
    for (std::string& text : trimmed.notes) note(model.notes, context, std::move(text));
    for (std::string& text : trimmed.warnings) warn(model.warnings, context, std::move(text));
  }
  model.plc = make_plc(model.arrangement.soup, model.surfaces, wells);
  context.note(LogLevel::info, std::to_string(model.arrangement.n_crossing_pairs) + " pairs of triangles cross; " +
                                   std::to_string(model.arrangement.soup.facets.size()) + " facets");
}

}  // namespace geomesh::geomodel
