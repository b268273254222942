// SPDX-License-Identifier: GPL-3.0-or-later
// The model of a project, declared in pipeline/jobs/prepare.hpp.
#include <nlohmann/json.hpp>

#include "common/thread_limit.hpp"
#include "coordinates/project_inputs.hpp"
#include "fractures/crossings.hpp"
#include "fractures/plane_polygons.hpp"
#include "geomesh/geomodel/ask_stack.hpp"
#include "geomesh/geomodel/sizes_in_range.hpp"
#include "geomesh/geomodel/words.hpp"
#include "grid_sizes/size_grid.hpp"
#include "level_sets/level_surfaces.hpp"
#include "naming/region_facts.hpp"
#include "pipeline/jobs/prepare.hpp"
#include "plausibility/plausibility.hpp"

namespace geomesh::geomodel {
namespace {

/// The volume in the project's system with elevation up: its bounds, and its corners in the map where it is no box
/// along the axes.
nlohmann::ordered_json describe_volume(const ModelVolume& volume, const PreparedModel& model) {
  const Vec3 min = volume.bounds.min + model.origin, max = volume.bounds.max + model.origin;
  nlohmann::ordered_json box{{"min", {min.x, min.y, min.z}}, {"max", {max.x, max.y, max.z}}};
  for (std::size_t i = 0; i + 2 < volume.sides.size(); ++i) {  // zmin and zmax are the last
    const Vec3 corner = volume.sides[i].points[0] + model.origin;
    box["corners"].push_back({corner.x, corner.y});
  }
  return box;
}

/// With z scaled, the scaled space counts and not the one that is written: the mesh is Delaunay there, and sizes and
/// shapes are those asked for there.
void refuse_scaling(const Project& project) {
  if (project.crs.z_scale == 1) return;
  const std::string where = project.file.filename().string() + ": crs.z_scale cannot be combined with ";
  if (project.mesh.options.recover.mode == MeshMode::conforming)
    throw Error(ErrorKind::usage,
                where + "mesh.mode: conforming, whose mesh would be Delaunay in the scaled space alone");
  if (project.mesh.refinement.refine)
    throw Error(ErrorKind::usage, where +
                                      "refinement (mesh.size, quality, honour or refine), which would judge sizes, "
                                      "shapes and the tolerance in the scaled "
                                      "space; leave out one of them");
}

/// From here on z is scaled, until the mesh is named. Rules have acted on the surfaces in true lengths.
void scale_z(PreparedModel& model, std::vector<Polyline>& wells) {
  ZScale& scale = model.z_scale;
  if (scale.factor() == 1) return;
  for (TriangulatedSurface& surface : model.surfaces) scale.apply(surface.points);
  for (Polyline& well : wells) scale.apply(well.points);
  for (NamedPoint& point : model.points) scale.apply(point.point);
  for (SurfaceRules& rule : model.rules.surfaces)
    for (FieldPart& part : rule.field_parts)
      for (FieldPart::Doubt& doubt : part.doubts) scale.apply(doubt.places);
  for (TriangulatedSurface& side : model.volume.sides) scale.apply(side.points);
  for (Box3* box : {&model.volume.bounds, model.volume.box ? &*model.volume.box : nullptr,
                    model.rules.box ? &*model.rules.box : nullptr}) {
    if (!box) continue;
    scale.apply(box->min);
    scale.apply(box->max);
  }
}

/// What cannot be meant or made is refused before hours are spent on it. Of a volume that is cut at the ground or at a
/// bottom, a tenth at least is taken to be left.
void refuse_sizes(const PreparedModel& model, const Box3& bounds) {
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

/// The triangulation of a level set is off its field by a share of the tolerance; the mesh is left the rest.
void use_tolerance_of_level_sets(const Project& project, RefinementSettings& r) {
  if (has_level_sets(project) && r.tolerance.left() > 0)
    r.tolerance.take({"level sets", level_set_share * r.tolerance.left()});
}

/// What was not asked for and yet steers the mesh.
void tell_sizes(PreparedModel& model, const RunContext& context) {
  const RefinementSettings& r = model.refinement;
  if (r.derive_size)
    note(model.notes, context,
         "edges of about " + short_words(r.size.base.global) + " " + model.unit +
             ": nothing asks for a size (mesh: {size: L}), so the model's volume does, for about " +
             short_words(r.derived_elements) + " elements");
  if (r.tolerance.follows_sizes())
    note(model.notes, context,
         "surfaces may be off the input by a twentieth of the size asked at the place, here " +
             short_words(r.tolerance.left()) + " " + model.unit +
             " at most, and by half of the gap to the next at most");
}

/// The tolerance counts from the surfaces as they were made. Where one of them is farther off its data than that, the
/// user is told, because "within the tolerance of the input" would be read as "of the data".
void book_misfits(PreparedModel& model, std::vector<ToleranceUse> uses, const RunContext& context) {
  ToleranceLedger& ledger = model.refinement.tolerance;
  for (ToleranceUse& use : uses) {
    if (ledger.requested() > 0 && *use.moved > ledger.requested()) {
      const std::string near = use.place ? " near " + to_text(*use.place) : std::string();
      const char* const cure = use.stage == "gridding"
                                   ? "a smaller spacing or smoothing (gridding: {spacing: L, "
                                     "smoothing: L}) is nearer to the points"
                                   : "fewer passes (smooth) or shorter edges (resample) move it less";
      warn(model.warnings, context,
           use.surface + ": " + use.stage + " put the surface " + short_words(*use.moved) + " " + model.unit +
               " off its data" + near + ", while the mesh keeps it within " + short_words(ledger.requested()) + " " +
               model.unit + "; " + cure);
    }
    ledger.take(std::move(use));
  }
}

std::string describe_input(const Project& project, const PreparedModel& model) {
  nlohmann::ordered_json input;
  input["project"] = project.file.filename().string();
  input["crs"] = {{"horizontal", project.crs.horizontal},
                  {"mesh", model.system},
                  {"z", project.crs.depth ? "depth" : "elevation"},
                  {"unit", project.crs.unit}};
  if (!project.crs.z_datum.empty()) input["crs"]["z_datum"] = project.crs.z_datum;
  if (project.crs.z_scale != 1) input["crs"]["z_scale"] = project.crs.z_scale;
  if (project.box) input["box"] = describe_volume(model.volume, model);
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

/// Nonsense ends the run here, before anything is built; doubts are warnings, and what may be meant is a note.
void doubt_inputs(const Project& project, const ProjectInputs& inputs, PreparedModel& model,
                  const RunContext& context) {
  std::optional<Box3> volume;
  if (inputs.volume) volume = model.volume.bounds;
  const std::vector<Finding> findings = find_doubts(project, inputs, volume);
  for (const Finding& finding : findings) {
    if (finding.sureness == Finding::Sureness::possible) note(model.notes, context, to_text(finding));
    if (finding.sureness == Finding::Sureness::probable) warn(model.warnings, context, to_text(finding));
    model.doubted.insert(model.doubted.end(), finding.inputs.begin(), finding.inputs.end());
  }
  refuse_nonsense(findings);
}

}  // namespace

void prepare_project(const Project& project, PreparedModel& model, const RunContext& context) {
  const ThreadLimit limit(context.threads);
  refuse_scaling(project);
  ProjectInputs inputs = [&] {
    StageScope stage(context, "read");
    return read_project_inputs(project, context);
  }();
  for (const std::string& text : project.notes) note(model.notes, context, text);
  for (std::string& text : inputs.notes) note(model.notes, context, std::move(text));
  for (std::string& text : inputs.warnings) warn(model.warnings, context, std::move(text));
  if (inputs.volume) {
    model.volume = make_volume(*inputs.volume, inputs.surfaces, Vec3{});
    if (!model.volume.note.empty()) note(model.notes, context, model.volume.note);
  }
  doubt_inputs(project, inputs, model, context);
  model.surfaces = std::move(inputs.surfaces);
  model.points = std::move(inputs.points);
  model.tops = std::move(inputs.tops);
  model.naming = project.naming;
  for (NamedPoint& seed : model.naming.seeds) seed.point = inputs.frame.point(seed.point);
  model.system = inputs.frame.system().name();
  model.rules = project.rules;
  if (inputs.volume) model.rules.box = model.volume.bounds;
  model.origin = project.output.origin;
  model.unit = project.crs.unit;
  model.options = project.mesh.options;
  model.refinement = project.mesh.refinement;
  for (PlaceSize& near : model.refinement.size.near) near.place = inputs.frame.point(near.place) + model.origin;
  load_background(model.refinement.size, model.origin);
  ArrangementOptions options;
  options.tolerance = project.merge_within;
  settle_sizes(model.refinement, inputs.volume ? model.volume.bounds : bounds_of(model.surfaces),
               model.naming.attributes, model.origin);
  refuse_sizes(model, inputs.volume ? model.volume.bounds : bounds_of(model.surfaces));
  book_misfits(model, std::move(inputs.uses), context);
  use_tolerance_of_level_sets(project, model.refinement);
  tell_sizes(model, context);
  std::vector<std::string> found, doubts;
  inputs.add_throws(model.rules);
  inputs.complete_field_parts(model.rules);
  find_ramps(model.surfaces, model.rules, found);
  leave_out_unreached_faults(model.surfaces, model.rules, doubts);
  for (std::string& text : found) note(model.notes, context, std::move(text));
  for (std::string& text : doubts) warn(model.warnings, context, std::move(text));
  ask_stack(model.rules, model.refinement, model.volume);
  ask_continuation(model.rules, model.refinement, model.volume);
  model.input_json = describe_input(project, model);
  build(model, context);
  model.z_scale = ZScale(project.crs.z_scale);
  scale_z(model, inputs.wells);
  if (inputs.volume) {
    options.box = model.volume.box;
    options.volume = model.volume.sides;
  }
  intersect(model, inputs.wells, options, context);
}

}  // namespace geomesh::geomodel
