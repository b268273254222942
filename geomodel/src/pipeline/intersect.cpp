// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/prepare.hpp"

namespace geomesh::geomodel {

void intersect(PreparedModel& model, const std::vector<Polyline>& wells, const ArrangementOptions& options,
               const RunContext& context) {
  StageScope stage(context, "intersect");
  model.arrangement = arrange(model.surfaces, wells, model.points, options, context);
  for (const std::string& text : model.arrangement.warnings) warn(model.warnings, context, text);
  for (const TriangulatedSurface& side : model.arrangement.box_sides) model.surfaces.push_back(side);
  model.plc = make_plc(model.arrangement.soup, model.surfaces, wells);
  context.note(LogLevel::info, std::to_string(model.arrangement.n_crossing_pairs) + " pairs of triangles cross; " +
                                   std::to_string(model.arrangement.soup.facets.size()) + " facets");
}

}  // namespace geomesh::geomodel
