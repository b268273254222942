// SPDX-License-Identifier: GPL-3.0-or-later
#include "geomesh/geomodel/report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "geomesh/geomodel/warnings.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "naming/sums.hpp"
#include "report/named_parts.hpp"
#include "report/quality.hpp"

namespace geomesh::geomodel {

namespace {

using json = nlohmann::ordered_json;

json to_json(const Vec3& p) { return json::array({p.x, p.y, p.z}); }

json stages_json(const std::vector<StageRecord>& stages) {
  json list = json::array();
  for (const StageRecord& s : stages)
    list.push_back(
        {{"name", s.name}, {"wall_s", s.wall_s}, {"cpu_s", s.cpu_s}, {"peak_bytes", s.peak_bytes}, {"runs", s.runs}});
  return list;
}

json recovery_json(const RecoveryStatistics& r) {
  return {{"segments_total", r.segments_total},
          {"facets_total", r.facets_total},
          {"missing_edges_initial", r.missing_edges_initial},
          {"missing_facets_before_segments", r.missing_facets_before_segments},
          {"missing_facets_initial", r.missing_facets_initial},
          {"edges_reinserted", r.edges_reinserted},
          {"facets_reinserted", r.facets_reinserted},
          {"facets_not_recovered", r.facets_not_recovered},
          {"steiner_on_segments", r.steiner_on_segments},
          {"steiner_on_facets", r.steiner_on_facets},
          {"steiner_inside", r.steiner_inside},
          {"tetrahedra_unconstrained", r.tetrahedra_unconstrained},
          {"tetrahedra_final", r.tetrahedra_final}};
}

json voronoi_json(const VoronoiDual& d) {
  return {{"edges", d.edges},
          {"negative_areas", d.negative},
          {"negative_areas_on_border", d.negative_on_border},
          {"least_relative_area", d.least}};
}

std::vector<std::string> surface_names(const Report& report) {
  if (!report.surface_names.empty() || !report.mesh) return report.surface_names;
  std::vector<std::string> names;
  for (const NamedSurface& s : report.mesh->surfaces) names.push_back(s.name);
  return names;
}

std::string name_at(const std::vector<std::string>& names, std::size_t row) {
  return row < names.size() ? names[row] : std::string("surface ").append(std::to_string(row + 1));
}

json displacement_json(const Displacement& d) {
  return {{"largest", d.largest}, {"mean", d.mean}, {"where", to_json(d.where)}, {"points_moved", d.points_moved}};
}

json spots_json(const std::vector<Spot>& spots, const std::vector<std::string>& names) {
  json list = json::array();
  for (const Spot& s : spots) {
    json spot{{"what", s.what}};
    if (s.surface_a != no_index) spot["surface_a"] = name_at(names, s.surface_a);
    if (s.surface_b != no_index) spot["surface_b"] = name_at(names, s.surface_b);
    spot["count"] = s.count;
    spot["measure"] = s.measure;
    if (s.area > 0) spot["area"] = s.area;
    spot["place"] = to_json(s.place);
    list.push_back(std::move(spot));
  }
  return list;
}

/// Returns the area that each surface lost to bodies, to the box and to rules; surfaces that lost nothing are left out.
json clipping_json(const ArrangementResult& a, const std::vector<std::string>& names) {
  json list = json::array();
  CompensatedSum by_bodies, by_box, by_rules;
  for (std::size_t i = 0; i < a.area_clipped_by_bodies.size() && i < a.area_clipped_by_box.size(); ++i) {
    by_bodies.add(a.area_clipped_by_bodies[i]);
    by_box.add(a.area_clipped_by_box[i]);
    const double rules = i < a.area_clipped_by_rules.size() ? a.area_clipped_by_rules[i] : 0;
    by_rules.add(rules);
    if (a.area_clipped_by_bodies[i] == 0 && a.area_clipped_by_box[i] == 0 && rules == 0) continue;
    list.push_back({{"surface", name_at(names, i)},
                    {"area_by_bodies", a.area_clipped_by_bodies[i]},
                    {"area_by_box", a.area_clipped_by_box[i]},
                    {"area_by_rules", rules}});
  }
  return {{"area_by_bodies", by_bodies.value()},
          {"area_by_box", by_box.value()},
          {"area_by_rules", by_rules.value()},
          {"surfaces", std::move(list)}};
}

void add_arrangement(const ArrangementResult& a, const std::vector<std::string>& names, json& root) {
  json merging = displacement_json(a.merging.displacement);
  merging["vertices_merged"] = a.merging.vertices_merged;
  merging["vertices_inserted"] = a.merging.vertices_inserted;
  merging["facets_merged"] = a.merging.facets_merged;
  merging["facets_collapsed"] = a.merging.facets_collapsed;
  merging["pockets_closed"] = a.merging.pockets_closed;
  root["displacement"] = {{"rounding", displacement_json(a.rounding)},
                          {"merging", std::move(merging)},
                          {"clipping", clipping_json(a, names)}};
  root["intersection"] = {{"pairs_tested", a.n_pairs},
                          {"pairs_crossing", a.n_crossing_pairs},
                          {"rounding_rounds", a.n_rounding_rounds},
                          {"memory_bound", a.memory_bound},
                          {"facets", a.soup.facets.size()},
                          {"points", a.soup.points.size()},
                          {"spots", spots_json(a.spots, names)}};
}

/// Returns the surfaces that were continued to the surfaces that bound them, and the gaps that were filled.
json continued_json(std::span<const ContinuedSurface> continued) {
  json list = json::array();
  for (const ContinuedSurface& c : continued) {
    json entry{{"surface", c.name}, {"to", c.walls}, {"border", c.length}, {"farthest", c.farthest}, {"area", c.area}};
    if (c.area > 0) entry["where"] = {c.place.x, c.place.y, c.place.z};
    entry["area_filled"] = c.area_filled;
    if (c.area_filled > 0) entry["where_filled"] = {c.place_filled.x, c.place_filled.y, c.place_filled.z};
    list.push_back(std::move(entry));
  }
  return list;
}

json open_borders_json(std::span<const OpenBorders> borders) {
  json list = json::array();
  for (const OpenBorders& open : borders) {
    json entry{{"horizon", open.horizon},
               {"holes", open.are_holes},
               {"count", open.count},
               {"length", open.length},
               {"where", {open.place.x, open.place.y, open.place.z}},
               {"joins_units", open.joins_units}};
    if (!open.region.empty()) entry["region"] = open.region;
    list.push_back(std::move(entry));
  }
  return list;
}

json tolerance_json(const ToleranceLedger& ledger) {
  json uses = json::array();
  for (const ToleranceUse& use : ledger.uses()) {
    json entry{{"stage", use.stage}, {"taken", use.taken}};
    if (use.by_own_key) entry["by_own_key"] = true;
    if (use.moved) entry["moved"] = *use.moved;
    if (!use.surface.empty()) entry["surface"] = use.surface;
    if (use.place) entry["place"] = to_json(*use.place);
    uses.push_back(std::move(entry));
  }
  return {{"requested", ledger.requested()},
          {"follows_sizes", ledger.follows_sizes()},
          {"left", ledger.left()},
          {"uses", std::move(uses)}};
}

/// Adds to the report the part of the tolerance that each stage used. The requested tolerance is also listed in
/// `input`.
void add_tolerance(const ToleranceLedger& ledger, json& root) {
  if (root.contains("input") && root["input"].contains("mesh") && ledger.requested() > 0)
    root["input"]["mesh"]["tolerance"] = ledger.requested();
  if (ledger.requested() > 0 || !ledger.uses().empty()) root["tolerance"] = tolerance_json(ledger);
}

json stack_json(const SettledStack& stack) {
  json horizons = json::array(), units = json::array();
  for (const SettledHorizon& h : stack.horizons)
    horizons.push_back({{"name", h.name},
                        {"triangles_given", h.n_triangles_given},
                        {"triangles", h.n_triangles},
                        {"area", h.area},
                        {"area_merged", h.area_merged},
                        {"area_above_topography", h.area_above_topography},
                        {"area_moved", h.area_moved},
                        {"mean_move", h.mean_move},
                        {"largest_move", h.largest_move},
                        {"where", to_json(h.place)},
                        {"largest_off_elsewhere", h.largest_off},
                        {"area_at_faults", h.area_at_faults},
                        {"largest_move_at_faults", h.largest_move_at_faults}});
  for (const SettledUnit& u : stack.units)
    units.push_back({{"name", u.name},
                     {"top", u.top},
                     {"base", u.base},
                     {"area", u.area},
                     {"area_merged", u.area_merged},
                     {"volume", u.volume},
                     {"mean_thickness", u.mean_thickness},
                     {"largest_thickness", u.largest_thickness},
                     {"islands_left_out", u.n_islands},
                     {"pinch_out_lines", u.pinch_outs.size()}});
  return {{"size", stack.size},
          {"tolerance", stack.tolerance},
          {"share_of_tolerance", stack_share},
          {"min_thickness", stack.min_thickness},
          {"horizons", std::move(horizons)},
          {"units", std::move(units)}};
}

json tops_json(const std::vector<FittedTop>& tops, const Vec3& origin) {
  json list = json::array();
  const auto number = [](double v) { return std::isnan(v) ? json() : json(v); };
  for (const FittedTop& t : tops)
    list.push_back({{"well", t.well},
                    {"horizon", t.horizon},
                    {"place", to_json(t.place + origin)},
                    {"misfit_given", number(t.misfit_given)},
                    {"misfit_fitted", number(t.misfit_fitted)},
                    {"misfit_meshed", number(t.misfit_meshed)}});
  return list;
}

void add_mesh(const ModelMesh& mesh, json& root) {
  root["points"] = mesh.points.size();
  root["tetrahedra"] = mesh.tetrahedra.size();
  root["faces"] = mesh.faces.size();
  root["origin"] = to_json(mesh.origin);
  root.update(named_parts_json(mesh));
}

}  // namespace

json named_parts_json(const ModelMesh& mesh) {
  json regions = json::array(), surfaces = json::array(), curves = json::array();
  for (const Region& r : mesh.regions) {
    regions.push_back(
        {{"id", r.id}, {"name", r.name}, {"tetrahedra", r.n_tetrahedra}, {"volume", r.volume}, {"inside", r.inside}});
    if (r.volume_of_input > 0) regions.back()["volume_of_input"] = r.volume_of_input;
  }
  for (const NamedSurface& s : mesh.surfaces)
    surfaces.push_back({{"id", s.id}, {"name", s.name}, {"kind", to_string(s.kind)}, {"area", s.area}});
  for (const NamedCurve& c : mesh.curves)
    curves.push_back({{"id", c.id}, {"name", c.name}, {"kind", c.kind}, {"length", c.length}});
  for (const auto& p : mesh.marked_points)
    curves.push_back({{"id", p.id}, {"name", p.name}, {"kind", "point"}, {"length", 0.0}});
  return {{"regions", std::move(regions)}, {"surfaces", std::move(surfaces)}, {"curves", std::move(curves)}};
}

namespace {

json warning_groups_json(const std::vector<std::string>& warnings) {
  json groups = json::array();
  for (const WarningGroup& g : group_warnings(warnings))
    groups.push_back({{"cause", g.cause}, {"count", g.count}, {"first", g.first}});
  return groups;
}

}  // namespace

std::string to_json(const Report& report) {
  json root;
  root["command"] = report.command;
  root["name"] = report.name;
  root["stages"] = stages_json(report.stages);
  if (!report.input_json.empty()) root["input"] = json::parse(report.input_json);
  if (report.core) {
    root["points_deferred"] = report.core->delaunay_statistics.points_deferred;
    root["delaunay"] = report.core->delaunay;
    root["recovery"] = recovery_json(report.core->recovery);
  }
  if (report.mesh) add_mesh(*report.mesh, root);
  if (report.arrangement) add_arrangement(*report.arrangement, surface_names(report), root);
  if (report.tolerance) add_tolerance(*report.tolerance, root);
  if (report.stack) root["stack"] = stack_json(*report.stack);
  if (!report.continued.empty()) root["continued"] = continued_json(report.continued);
  if (report.mesh && !report.mesh->open_borders.empty())
    root["open_borders"] = open_borders_json(report.mesh->open_borders);
  if (!report.tops.empty()) root["tops"] = tops_json(report.tops, report.mesh ? report.mesh->origin : Vec3{});
  if (report.refinement) {
    const QualityReport* const quality = report.quality ? &*report.quality : nullptr;
    root["refinement"] = refinement_json(*report.refinement, quality);
  }
  if (report.quality) root["quality"] = quality_json(*report.quality, report.mesh);
  if (report.solver) root["solver"] = json::parse(to_json(*report.solver));
  if (report.voronoi_dual) root["voronoi_dual"] = voronoi_json(*report.voronoi_dual);
  root["notes"] = report.notes;
  root["warnings"] = report.warnings;
  root["warning_groups"] = warning_groups_json(report.warnings);
  root["files"] = report.files;
  return root.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

void write_report(const Report& report, const std::filesystem::path& file) { write_text_file(file, to_json(report)); }

}  // namespace geomesh::geomodel
