// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the stage build, declared in pipeline/stages/stages.hpp.
#include "pipeline/stages/stages.hpp"
#include "stack/settled_report.hpp"

namespace geomesh::geomodel {
namespace {

/// Names the regions between horizons that were put in order: by unit, or by unit and fault block. Remnants smaller
/// than a tenth of an element are merged into a neighbouring region. A unit with the volume of about one element in a
/// block is not a remnant: with coarse sizes, it is as thick as others.
void name_by_unit_and_block(NamingRules& naming, const SettledStack& stack) {
  constexpr double element = 0.118;  // volume of a regular tetrahedron divided by the cube of its edge
  constexpr double least_share = 0.1;
  naming.join_pieces = true;
  naming.fault_blocks = true;
  if (naming.min_volume > 0) return;
  naming.min_volume = least_share * element * stack.size * stack.size * stack.size;
  naming.merge_small = true;
}

/// Gives the surfaces of thin units a smaller tolerance, and the sizes that their thickness requires.
void ask_of_thin_units(RefinementSettings& r, const SettledStack& stack) {
  if (stack.sizes.empty()) return;
  r.tolerance.limit_share(stack_tolerance_of_size);
  std::vector<SizeSource>& sources = r.size.base.sources;
  sources.insert(sources.end(), stack.sizes.begin(), stack.sizes.end());
}

/// Multiplies z of the built model by its scale factor. Rules were applied before, in unscaled lengths.
void scale_z(Built& model) {
  ZScale& scale = model.z_scale;
  if (scale.factor() == 1) return;
  for (TriangulatedSurface& surface : model.surfaces) scale.apply(surface.points);
  for (Polyline& well : model.wells) scale.apply(well.points);
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

Built with_settings_of(const Inputs& inputs) {
  Built built;
  built.wells = inputs.wells;
  built.points = inputs.points;
  built.rules = inputs.rules;
  built.volume = inputs.volume;
  built.naming = inputs.naming;
  built.refinement = inputs.refinement;
  built.z_scale = ZScale(inputs.z_scale);
  return built;
}

}  // namespace

Built build_model(const Inputs& inputs, Journal& journal) {
  const StageScope stage(journal.context(), "build");
  BuiltSurfaces made = build_surfaces(inputs.surfaces, inputs.rules, journal.context());
  Built built = with_settings_of(inputs);
  built.surfaces = std::move(made.surfaces);
  built.rows = std::move(made.rows);
  built.stack = std::move(made.stack);
  built.continued = std::move(made.continued);
  if (built.stack.settled) {
    for (std::string& text : notes_of(built.stack)) journal.note(std::move(text));
    for (ToleranceUse& use : uses_of(built.stack)) built.refinement.tolerance.take(std::move(use));
    ask_of_thin_units(built.refinement, built.stack);
    name_by_unit_and_block(built.naming, built.stack);
  }
  for (std::string& text : made.notes) journal.note(std::move(text));
  journal.warn_all(std::move(made.warnings));
  scale_z(built);
  return built;
}

Built built_as_given(const Inputs& inputs) {
  Built built = with_settings_of(inputs);
  built.surfaces = inputs.surfaces;
  return built;
}

}  // namespace geomesh::geomodel
