// SPDX-License-Identifier: GPL-3.0-or-later
// Rules before the arrangement, in order, declared in geomesh/geomodel/model_rules.hpp.
#include <algorithm>
#include <map>

#include "geomesh/core/error.hpp"
#include "naming/sheets.hpp"
#include "rules/blocks/build_blocks.hpp"
#include "rules/column_order.hpp"
#include "rules/continuation/continue_to_walls.hpp"
#include "rules/dyke.hpp"
#include "rules/extend/extend.hpp"
#include "rules/fault_ends.hpp"
#include "rules/framework/up_to_walls.hpp"
#include "rules/framework/walls.hpp"
#include "rules/thin_layers.hpp"
#include "stack/settle_stack.hpp"

namespace geomesh::geomodel {
namespace {

/// The box, and in the map the horizons with throw, so that no sheet goes round a continuation beyond the box.
Box3 reach_of_continuations(const BuiltSurfaces& built, const ModelRules& rules) {
  Box3 reach = *rules.box;
  for (std::size_t s = 0; s < built.surfaces.size(); ++s)
    for (const Vec3& p : built.surfaces[s].points)
      if (!rules.of(s).throw_at.empty()) reach.add({p.x, p.y, reach.min.z});
  return reach;
}

/// Faults across which a horizon has throw and that are kept as given are continued beyond where they end inside the
/// box.
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
        part.resize(fault.triangles.size(), 0);  // it goes with what parts blocks
    }
}

/// A body is closed at the box, or made of a sheet.
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

/// The stack is settled by what lies in the blocks: continuations go on beyond walls, over what is given there.
bool settle(BuiltSurfaces& built, const ModelRules& rules) {
  const bool any =
      std::any_of(built.continued.begin(), built.continued.end(), [](const ContinuedSurface& c) { return c.area > 0; });
  if (!any || !asks_for_settling(rules.stack)) return settle_stack(built, rules);
  const std::vector<TriangulatedSurface> given = built.surfaces;
  std::vector<TriangulatedSurface> cut = horizons_up_to_walls(built, rules);
  for (Index s = 0; s < cut.size(); ++s)
    if (!cut[s].triangles.empty()) built.surfaces[s] = cut[s];
  const bool settled = settle_stack(built, rules);
  for (Index s = 0; s < cut.size(); ++s)
    if (!cut[s].triangles.empty() && !built.rows.part_of_triangle[s].empty()) built.surfaces[s] = given[s];
  return settled;
}

BuiltSurfaces build(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules,
                    const std::vector<Index>& fill_blocks, const RunContext& context) {
  BuiltSurfaces built;
  built.surfaces = surfaces;
  built.rows.block_of_triangle.resize(surfaces.size());
  built.rows.sides_of_block.resize(surfaces.size());
  built.rows.parted_at.resize(surfaces.size());
  const BuildLog log{built.notes, built.warnings};
  built.rows.n_given_triangles.reserve(surfaces.size());
  for (const TriangulatedSurface& s : surfaces)
    built.rows.n_given_triangles.push_back(static_cast<Index>(s.triangles.size()));
  built.rows.part_of_triangle.resize(surfaces.size());
  built.rows.continued_to.resize(surfaces.size());
  warn_of_column_order(surfaces, rules, log);
  continue_faults(built, rules, log);
  continue_throw_faults(built, rules);
  std::vector<std::size_t> order;  // horizons with throw after the faults that they are sorted by
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
    if ((rule.extend != Extend::none || !rule.throw_at.empty()) && !rules.box)
      throw Error(ErrorKind::usage,
                  "surface " + surface.name + ": extend needs a box to extend to; give the project a box");
    if (built.rows.first_only_parting[s] != no_index) continue;  // continued, and filled, above
    if (rule.fill_holes > 0) fill_holes(surface, rule.fill_holes, log);
    if (surface.kind == SurfaceKind::body) {
      build_body(surface, rule, rules.box, log);
    } else if (!rule.throw_at.empty() && !surface.triangles.empty()) {
      build_blocks(built, s, rules, log);
    } else if (rule.extend != Extend::none) {
      extend_to_box(surface, rule.extend, *rules.box, log);
    }
  }
  pass_on();
  continue_horizons(built, rules, fill_blocks, log);
  if (rules.thin_layers == ThinLayers::error && rules.min_thickness > 0) apply_min_thickness(built, rules);
  if (!settle(built, rules) && rules.min_thickness > 0 && rules.thin_layers != ThinLayers::error)
    apply_min_thickness(built, rules);
  return built;
}

/// Horizons whose faults with throw were found from data that none of these crosses: they are given block by block, and
/// there is no throw to restore.
std::vector<Index> given_by_block(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules) {
  std::map<Index, TriangulatedSurface> faults;  // as they are built, up to their ends
  std::vector<std::string> notes, warnings;     // told where the surfaces are built
  const auto fault_of = [&](Index row) -> const TriangulatedSurface& {
    const auto [at, is_new] = faults.emplace(row, TriangulatedSurface{});
    if (!is_new) return at->second;
    at->second = surfaces[row];
    if (rules.of(row).extend != Extend::none && rules.box)
      extend_to_box(at->second, rules.of(row).extend, *rules.box, {notes, warnings});
    return at->second;
  };
  std::vector<Index> rows;
  for (Index s = 0; s < surfaces.size(); ++s) {
    const SurfaceRules rule = rules.of(s);
    if (!rule.throw_auto || rule.throw_at.empty()) continue;
    std::vector<TriangulatedSurface> own;
    std::vector<Index> all;
    for (const std::string& name : rule.throw_at) {
      all.push_back(static_cast<Index>(own.size()));
      own.push_back(fault_of(static_cast<Index>(throw_fault(surfaces, surfaces[s], name))));
    }
    const Walls walls(own, all, {});
    const std::vector<Vec3>& p = surfaces[s].points;
    const auto is_crossed = [&](const Triangle& t) {
      return walls.first_surface(p[t[0]], p[t[1]], no_index) || walls.first_surface(p[t[1]], p[t[2]], no_index) ||
             walls.first_surface(p[t[2]], p[t[0]], no_index);
    };
    if (std::ranges::none_of(surfaces[s].triangles, is_crossed)) rows.push_back(s);
  }
  return rows;
}

}  // namespace

BuiltSurfaces build_surfaces(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules,
                             const RunContext& context) {
  const std::vector<Index> by_block = given_by_block(surfaces, rules);
  if (by_block.empty() || asks_for_settling(rules.stack)) {
    BuiltSurfaces built = build(surfaces, rules, {}, context);
    if (by_block.empty() || built.stack.settled) return built;
  }
  ModelRules without_throw = rules;
  for (const Index s : by_block) {
    without_throw.surfaces[s].throw_at.clear();
    without_throw.surfaces[s].throw_auto = false;
    without_throw.surfaces[s].extend = Extend::none;
  }
  return build(surfaces, without_throw, by_block, context);
}

}  // namespace geomesh::geomodel
