// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the stage read for a project, declared in pipeline/stages/stages.hpp.
#include <nlohmann/json.hpp>

#include "common/thread_limit.hpp"
#include "coordinates/project_inputs.hpp"
#include "fractures/crossings.hpp"
#include "fractures/plane_polygons.hpp"
#include "geomesh/geomodel/ask_stack.hpp"
#include "geomesh/geomodel/gridding_in_blocks.hpp"
#include "geomesh/geomodel/sizes_in_range.hpp"
#include "geomesh/geomodel/words.hpp"
#include "grid_sizes/size_grid.hpp"
#include "level_sets/level_surfaces.hpp"
#include "naming/region_facts.hpp"
#include "pipeline/stages/stages.hpp"
#include "plausibility/plausibility.hpp"

namespace geomesh::geomodel {
namespace {

/// Describes the model volume in the project's coordinate system with elevation up: its bounds, and its corners in the
/// map if it is not a box along the axes.
nlohmann::ordered_json describe_volume(const ModelVolume& volume, const Vec3& origin) {
  const Vec3 min = volume.bounds.min + origin, max = volume.bounds.max + origin;
  nlohmann::ordered_json box{{"min", {min.x, min.y, min.z}}, {"max", {max.x, max.y, max.z}}};
  for (std::size_t i = 0; i + 2 < volume.sides.size(); ++i) {  // the last two sides of a volume are bottom and top
    const Vec3 corner = volume.sides[i].points[0] + origin;
    box["corners"].push_back({corner.x, corner.y});
  }
  return box;
}

/// Refuses requests for sizes, shapes or the Delaunay property if z is scaled, because they would refer to the scaled
/// space and not to the one that is written.
void refuse_scaling(const Project& project) {
  if (project.crs.z_scale == 1) return;
  const std::string where = project.file.filename().string() + ": crs.z_scale cannot be combined with ";
  if (project.mesh.options.recover.mode == MeshMode::conforming)
    throw Error(ErrorKind::usage,
                where + "mesh.mode: conforming, whose mesh would be Delaunay in the scaled space alone");
  if (project.mesh.refinement.refine)
    throw Error(ErrorKind::usage, where +
                                      "refinement (mesh.size, quality, honour or refine), which would check sizes, "
                                      "shapes and the tolerance in the scaled "
                                      "space; leave out one of them");
}

/// Refuses target sizes that are absurd or impossible before hours are spent on them. If the ground or a base cuts the
/// model volume, at least a tenth of the volume is assumed to remain.
void refuse_sizes(const Inputs& model, const Box3& bounds) {
  require_sizes_in_range(model.refinement, bounds);
  constexpr double least_left = 0.1;
  const bool is_cut = !model.rules.topography.empty() || !model.rules.floor.empty();
  require_countable(model.refinement, (is_cut ? least_left : 1) * model.volume.volume, model.unit);
  std::vector<const TriangulatedSurface*> fractures;
  const std::vector<bool> is_fracture = plane_polygons(model.surfaces, model.rules);
  for (std::size_t s = 0; s < is_fracture.size(); ++s)
    if (is_fracture[s]) fractures.push_back(&model.surfaces[s]);
  require_countable(estimate_crossings(fractures, bounds), fractures.size(), model.refinement);
}

/// Subtracts from the tolerance of the mesh the distance by which triangulated level sets may deviate from their
/// fields.
void use_tolerance_of_level_sets(const Project& project, RefinementSettings& r) {
  if (has_level_sets(project) && r.tolerance.left() > 0)
    r.tolerance.take({"level sets", level_set_share * r.tolerance.left()});
}

/// Reports the size and the tolerance of the mesh if the user did not choose them.
void tell_sizes(const Inputs& model, Journal& journal) {
  const RefinementSettings& r = model.refinement;
  if (r.derive_size)
    journal.note("edges of about " + short_words(r.size.base.global) + " " + model.unit +
                 ": no size is requested (mesh: {size: L}), so it follows from the model's volume, for about " +
                 short_words(r.derived_elements) + " elements");
  if (r.tolerance.follows_sizes())
    journal.note("surfaces may be off the input by a twentieth of the size requested at the place, here " +
                 short_words(r.tolerance.left()) + " " + model.unit +
                 " at most, and by half of the gap to the next at most");
}

/// Records how far surfaces are from their data, because the mesh's tolerance counts from the surfaces as they were
/// made. Warns if a surface is farther from its data than the tolerance; otherwise users would take "within the
/// tolerance of the input" as "of the data".
void book_misfits(ToleranceLedger& ledger, std::vector<ToleranceUse> uses, const std::string& unit, Journal& journal) {
  for (ToleranceUse& use : uses) {
    if (ledger.requested() > 0 && *use.moved > ledger.requested()) {
      const std::string near = use.place ? " near " + to_text(*use.place) : std::string();
      const char* const cure = use.stage == "gridding"
                                   ? "a smaller spacing or smoothing (gridding: {spacing: L, "
                                     "smoothing: L}) is nearer to the points"
                                   : "fewer passes (smooth) or shorter edges (resample) move it less";
      journal.warn(use.surface + ": " + use.stage + " put the surface " + short_words(*use.moved) + " " + unit +
                   " off its data" + near + ", while the mesh keeps it within " + short_words(ledger.requested()) +
                   " " + unit + "; " + cure);
    }
    ledger.take(std::move(use));
  }
}

std::string describe_input(const Project& project, const Inputs& model) {
  nlohmann::ordered_json input;
  input["project"] = project.file.filename().string();
  input["crs"] = {{"horizontal", project.crs.horizontal},
                  {"mesh", model.system},
                  {"z", project.crs.depth ? "depth" : "elevation"},
                  {"unit", project.crs.unit}};
  if (!project.crs.z_datum.empty()) input["crs"]["z_datum"] = project.crs.z_datum;
  if (project.crs.z_scale != 1) input["crs"]["z_scale"] = project.crs.z_scale;
  if (project.box) input["box"] = describe_volume(model.volume, model.origin);
  for (const TriangulatedSurface& s : model.surfaces)
    input["surfaces"].push_back({{"name", s.name},
                                 {"kind", to_string(s.kind)},
                                 {"file", s.file},
                                 {"cuts_all", s.cuts_all},
                                 {"points", s.points.size()},
                                 {"triangles", s.triangles.size()}});
  if (!project.column.empty()) input["column"] = project.column;
  for (const auto& [name, colour] : project.colours) input["colours"][name] = to_hex(colour);
  input["mesh"] = {{"mode", project.mesh.options.recover.mode == MeshMode::conforming ? "conforming" : "constrained"},
                   {"refine", project.mesh.refinement.refine ? "default" : "none"},
                   {"honour", project.mesh.refinement.honour == Honour::exact ? "exact" : "tolerance"},
                   {"preserve_boundary", project.mesh.options.recover.preserve_boundary}};
  const RefinementSettings& refinement = model.refinement;
  if (refinement.refine && refinement.size.base.global > 0) input["mesh"]["size"] = refinement.size.base.global;
  input["output"] = {{"formats", project.output.formats},
                     {"origin", {project.output.origin.x, project.output.origin.y, project.output.origin.z}}};
  return input.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// Ends the run before anything is built if inputs are certainly wrong. Likely errors become warnings, and oddities
/// that may be intended become notes. Returns the inputs that warnings concern.
std::vector<std::string> doubt_inputs(const Project& project, const ProjectInputs& inputs, const ModelVolume& made,
                                      Journal& journal) {
  std::vector<std::string> doubted;
  std::optional<Box3> volume;
  if (inputs.volume) volume = made.bounds;
  const std::vector<Finding> findings = find_doubts(project, inputs, volume);
  for (const Finding& finding : findings) {
    if (finding.sureness == Finding::Sureness::possible) journal.note(to_text(finding));
    if (finding.sureness == Finding::Sureness::probable) journal.warn(to_text(finding));
    doubted.insert(doubted.end(), finding.inputs.begin(), finding.inputs.end());
  }
  refuse_nonsense(findings);
  return doubted;
}

/// Completes the rules from the data: finds which faults displace which horizon, and how far surfaces are continued.
void complete_rules(Inputs& model, const ProjectInputs& inputs, Journal& journal) {
  std::vector<std::string> found, doubts;
  inputs.add_throws(model.rules);
  inputs.complete_field_parts(model.rules);
  find_ramps(model.surfaces, model.rules, found);
  leave_out_unreached_faults(model.surfaces, model.rules, doubts);
  for (std::string& text : found) journal.note(std::move(text));
  journal.warn_all(std::move(doubts));
  ask_stack(model.rules, model.refinement, model.volume);
  ask_continuation(model.rules, model.refinement, model.volume);
}

/// Makes horizons from their data points, separately in each fault block if faults separate the points. Replaces the
/// recorded distances of these horizons from their data points.
void grid_horizons_in_blocks(ProjectInputs& inputs, Inputs& model, Journal& journal) {
  if (inputs.gridded.empty()) return;
  ModelRules rules = model.rules;
  inputs.add_throws(rules);
  ask_continuation(rules, model.refinement, model.volume);
  for (const GriddedInBlocks& made : grid_in_blocks(model.surfaces, inputs.gridded, rules)) {
    const std::string& name = model.surfaces[made.row].name;
    journal.note(name + ": its points lie in " + std::to_string(made.n_blocks) +
                 " fault blocks, so a surface is made in each block from the points there" +
                 (made.n_in_common > 0 ? " (" + std::to_string(made.n_in_common) +
                                             " blocks have too few points and keep the surface of all points)"
                                       : "") +
                 "; residual at the points: rms " + short_words(made.rms_residual) + ", largest " +
                 short_words(made.largest_residual));
    for (ToleranceUse& use : inputs.uses)
      if (use.surface == name && use.stage == "gridding") {
        use.moved = std::abs(made.largest_residual);
        use.place = made.largest_place;
      }
  }
}

/// Derives target sizes and the tolerance, once the extent of the data is known.
void settle_refinement(const Project& project, ProjectInputs& inputs, Inputs& model, Journal& journal) {
  for (PlaceSize& near : model.refinement.size.near) near.place = inputs.frame.point(near.place) + model.origin;
  load_background(model.refinement.size, model.origin);
  const Box3 bounds = inputs.volume ? model.volume.bounds : bounds_of(model.surfaces);
  settle_sizes(model.refinement, bounds, model.naming.attributes, model.origin);
  refuse_sizes(model, bounds);
  grid_horizons_in_blocks(inputs, model, journal);
  book_misfits(model.refinement.tolerance, std::move(inputs.uses), model.unit, journal);
  use_tolerance_of_level_sets(project, model.refinement);
  tell_sizes(model, journal);
}

}  // namespace

Inputs read_project_model(const Project& project, Journal& journal) {
  const RunContext& context = journal.context();
  const ThreadLimit limit(context.threads);
  refuse_scaling(project);
  ProjectInputs inputs = [&] {
    StageScope stage(context, "read");
    return read_project_inputs(project, context);
  }();
  for (const std::string& text : project.notes) journal.note(text);
  for (std::string& text : inputs.notes) journal.note(std::move(text));
  journal.warn_all(std::move(inputs.warnings));
  Inputs model;
  model.command = "project";
  model.name = project.name;
  model.has_rules = true;
  model.rules = project.rules;
  if (inputs.volume) {
    model.volume = make_volume(*inputs.volume, inputs.surfaces, Vec3{});
    if (!model.volume.note.empty()) journal.note(model.volume.note);
    model.rules.box = model.volume.bounds;
  }
  model.doubted = doubt_inputs(project, inputs, model.volume, journal);
  model.surfaces = std::move(inputs.surfaces);
  model.wells = std::move(inputs.wells);
  model.points = std::move(inputs.points);
  model.tops = std::move(inputs.tops);
  model.naming = project.naming;
  for (NamedPoint& seed : model.naming.seeds) seed.point = inputs.frame.point(seed.point);
  model.system = inputs.frame.system().name();
  model.origin = project.output.origin;
  model.unit = project.crs.unit;
  model.z_scale = project.crs.z_scale;
  model.options = project.mesh.options;
  model.arrangement.tolerance = project.merge_within;
  model.refinement = project.mesh.refinement;
  settle_refinement(project, inputs, model, journal);
  complete_rules(model, inputs, journal);
  model.description = describe_input(project, model);
  return model;
}

}  // namespace geomesh::geomodel
