// SPDX-License-Identifier: GPL-3.0-or-later
// Applies, in order, the rules that precede the arrangement, declared in geomesh/geomodel/model_rules.hpp.
#include <algorithm>

#include "geomesh/core/error.hpp"
#include "naming/sheets.hpp"
#include "rules/blocks/build_blocks.hpp"
#include "rules/blocks/field_blocks.hpp"
#include "rules/column_order.hpp"
#include "rules/continuation/continue_to_walls.hpp"
#include "rules/dyke.hpp"
#include "rules/extend/extend.hpp"
#include "rules/fault_ends.hpp"
#include "rules/thin_layers.hpp"
#include "stack/settle_stack.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns the box, enlarged in the map to contain horizons with throw, lest these continue around a fault's extension.
Box3 reach_of_continuations(const BuiltSurfaces& built, const ModelRules& rules) {
  Box3 reach = *rules.box;
  for (std::size_t s = 0; s < built.surfaces.size(); ++s)
    for (const Vec3& p : built.surfaces[s].points)
      if (!rules.of(s).throw_at.empty()) reach.add({p.x, p.y, reach.min.z});
  return reach;
}

/// Extends faults that end inside the box, if a horizon has throw across them and no other rule extends them.
void continue_throw_faults(BuiltSurfaces& built, const ModelRules& rules) {
  built.rows.first_only_parting.assign(built.surfaces.size(), no_index);
  if (!rules.box) return;
  const Box3 reach = reach_of_continuations(built, rules);
  for (std::size_t s = 0; s < built.surfaces.size(); ++s)
    for (const std::string& name : rules.of(s).throw_at) {
      const std::size_t row = throw_fault(built.surfaces, built.surfaces[s], name);
      TriangulatedSurface& fault = built.surfaces[row];
      if (rules.of(row).extend != Extend::none || built.rows.first_only_parting[row] != no_index ||
          fault.triangles.empty())
        continue;
      if (rules.of(row).fill_holes > 0) fill_holes(fault, rules.of(row).fill_holes, {built.notes, built.warnings});
      built.rows.first_only_parting[row] = continue_fault(fault, *rules.box, reach);
      if (std::vector<Index>& part = built.rows.part_of_triangle[row]; !part.empty())
        // The extension of the fault counts as part of the original fault until remove_continuations() removes it.
        part.resize(fault.triangles.size(), 0);
    }
}

/// Closes a body at the box, or makes it from a surface with a thickness.
void build_body(TriangulatedSurface& body, const SurfaceRules& rule, const std::optional<Box3>& box,
                const BuildLog& log) {
  if (rule.thickness > 0) {
    if (rule.extend != Extend::none) extend_to_box(body, rule.extend, *box, log);
    thicken(body, rule.thickness, log);
  } else if (rule.close_at_box && box && !is_closed(body)) {
    close_body(body, *box, log);
  }
}

}  // namespace

std::vector<TriangulatedSurface> BuiltSurfaces::model_surfaces() const {
  std::vector<TriangulatedSurface> kept = surfaces;
  for (std::size_t s = 0; s < rows.first_only_parting.size(); ++s)
    if (rows.first_only_parting[s] < kept[s].triangles.size()) kept[s].triangles.resize(rows.first_only_parting[s]);
  return kept;
}

namespace {

BuiltSurfaces build(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules,
                    const std::vector<Index>& fill_blocks, const RunContext& context) {
  BuiltSurfaces built;
  built.surfaces = surfaces;
  built.rows.block_of_triangle.resize(surfaces.size());
  built.rows.sides_of_block.resize(surfaces.size());
  built.rows.on_both_sides.resize(surfaces.size());
  built.rows.parted_at.resize(surfaces.size());
  const BuildLog log{built.notes, built.warnings};
  built.rows.n_given_triangles.reserve(surfaces.size());
  for (const TriangulatedSurface& s : surfaces)
    built.rows.n_given_triangles.push_back(static_cast<Index>(s.triangles.size()));
  built.rows.part_of_triangle.resize(surfaces.size());
  built.rows.continued_to.resize(surfaces.size());
  built.rows.block_of_part.resize(surfaces.size());
  warn_of_column_order(surfaces, rules, log);
  continue_faults(built, rules, log);
  continue_throw_faults(built, rules);
  std::vector<std::size_t> order;  // horizons with throw come after the faults by which they are divided
  for (const bool has_throw : {false, true})
    for (std::size_t s = 0; s < surfaces.size(); ++s)
      if (!rules.of(s).throw_at.empty() == has_throw) order.push_back(s);
  const std::size_t n_steps = order.size() + 1;  // and the stack
  std::size_t n_done = 0;
  const auto pass_on = [&] {
    context.check_cancelled();
    context.report(n_done++, n_steps);
  };
  for (const std::size_t s : order) {
    pass_on();
    TriangulatedSurface& surface = built.surfaces[s];
    const SurfaceRules rule = rules.of(s);
    if ((rule.extend != Extend::none || rule.has_throw()) && !rules.box)
      throw Error(ErrorKind::usage,
                  "surface " + surface.name + ": extend needs a box to extend to; give the project a box");
    // Skips faults that were already extended to separate blocks, after their holes were filled.
    if (built.rows.first_only_parting[s] != no_index) continue;
    if (rule.fill_holes > 0) fill_holes(surface, rule.fill_holes, log);
    if (surface.kind == SurfaceKind::body) {
      build_body(surface, rule, rules.box, log);
    } else if (rule.has_fault_domain()) {
      part_by_fields(built, s, rules);
    } else if (!rule.throw_at.empty() && !surface.triangles.empty()) {
      build_blocks(built, s, rules, log);
    } else if (rule.extend != Extend::none && !rule.fills_blocks()) {
      extend_to_box(surface, rule.extend, *rules.box, log);
    }
  }
  pass_on();
  const std::optional<HorizonBlocks> blocks = continue_horizons(built, rules, fill_blocks, log);
  if (rules.thin_layers == ThinLayers::error && rules.min_thickness > 0) apply_min_thickness(built, rules);
  if (!settle_stack(built, rules, blocks ? &*blocks : nullptr) && rules.min_thickness > 0 &&
      rules.thin_layers != ThinLayers::error)
    apply_min_thickness(built, rules);
  return built;
}

}  // namespace

BuiltSurfaces build_surfaces(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules,
                             const RunContext& context) {
  std::vector<Index> fill_blocks;
  for (Index s = 0; s < surfaces.size(); ++s)
    if (rules.of(s).fills_blocks()) fill_blocks.push_back(s);
  return build(surfaces, rules, fill_blocks, context);
}

}  // namespace geomesh::geomodel
