// SPDX-License-Identifier: GPL-3.0-or-later
// Rules before the arrangement, in order, declared in geomesh/geomodel/model_rules.hpp.
#include <algorithm>

#include "geomesh/core/error.hpp"
#include "naming/sheets.hpp"
#include "rules/column_order.hpp"
#include "rules/dyke.hpp"
#include "rules/extend.hpp"
#include "rules/fault_ends.hpp"
#include "rules/smeared_throw.hpp"
#include "rules/thin_layers.hpp"
#include "rules/throw/throw_ramp.hpp"
#include "rules/throw_blocks.hpp"
#include "stack/settle_stack.hpp"

namespace geomesh::geomodel {
namespace {

/// Row of the fault that a horizon names under throw_at.
std::size_t throw_fault(const std::vector<TriangulatedSurface>& surfaces, const TriangulatedSurface& horizon,
                        const std::string& name) {
  const auto fault =
      std::find_if(surfaces.begin(), surfaces.end(), [&](const TriangulatedSurface& s) { return s.name == name; });
  if (fault == surfaces.end())
    throw Error(ErrorKind::usage, "horizon " + horizon.name + ": throw_at names " + name + ", which is no surface");
  return static_cast<std::size_t>(fault - surfaces.begin());
}

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

/// Ramps across the faults made anew.
RestoredThrow restore_ramps(TriangulatedSurface& horizon, const std::vector<RampFault>& faults,
                            const std::vector<TriangulatedSurface>& surfaces, const BuildLog& log) {
  std::vector<const TriangulatedSurface*> others;
  for (const TriangulatedSurface& surface : surfaces)
    if (surface.kind == SurfaceKind::fault &&
        std::none_of(faults.begin(), faults.end(), [&](const RampFault& f) { return f.fault.surface == &surface; }))
      others.push_back(&surface);
  return restore_smeared_throw(horizon, faults, others, log);
}

/// Whether the horizon goes round no end of the fault inside the box.
bool goes_through(const ThrowFault& fault, const TriangulatedSurface& horizon, const Box3& box) {
  if (fault.first_made == fault.surface->triangles.size()) return true;
  const std::vector<Crossing> crossing = find_crossings(horizon, 0, {fault}, box);
  return std::none_of(crossing.begin(), crossing.end(), [](Crossing c) { return c == Crossing::continuation; });
}

/// One sheet on both sides of all of its faults, which go through the model: parting it would take one side away.
bool stays_whole(const TriangulatedSurface& horizon, const std::vector<ThrowFault>& faults, const Box3& box) {
  TriangulatedSurface copy = horizon;
  std::vector<ThrowFault> through = faults;
  for (ThrowFault& f : through) f.first_made = static_cast<Index>(f.surface->triangles.size());
  std::vector<std::string> notes, warnings;
  return std::all_of(faults.begin(), faults.end(),
                     [&](const ThrowFault& f) {
                       return goes_through(f, horizon, box) && lies_on_both_sides(horizon, FaultFaces(*f.surface));
                     }) &&
         BuiltRows::n_blocks(sort_into_blocks(copy, {through, Extend::flat, {}}, {notes, warnings}, {}).of_triangle) ==
             1;
}

/// The faults through the model that a sheet of the horizon runs on across have no throw there: parting it would take
/// what lies beyond. Gives the rows of the others.
std::vector<std::size_t> leave_out_where_it_runs_on(const TriangulatedSurface& horizon,
                                                    const std::vector<std::size_t>& rows,
                                                    std::vector<ThrowFault>& faults, const Box3& box,
                                                    const BuildLog& log) {
  std::vector<std::size_t> parting;
  std::vector<ThrowFault> kept;
  for (std::size_t k = 0; k < faults.size(); ++k) {
    const TriangulatedSurface& fault = *faults[k].surface;
    if (goes_through(faults[k], horizon, box) && runs_on_across(horizon, faults, k)) {
      log.warnings.push_back("horizon " + horizon.name + ": it runs on across " + fault.name +
                             " as one sheet, so that it has no throw there (give it block by block)");
      continue;
    }
    parting.push_back(rows[k]);
    kept.push_back(faults[k]);
  }
  faults = std::move(kept);
  return parting;
}

/// Whether triangles cross faults one of which ends inside: what of them is beyond is not sure to be of another block.
bool overshoots_an_end(const TriangulatedSurface& horizon, const BlockFaults& parting) {
  if (std::none_of(parting.faults.begin(), parting.faults.end(),
                   [&](const ThrowFault& f) { return ends_inside(f, parting.box); }))
    return false;
  const std::vector<Crossing> crossing = find_crossings(horizon, 0, parting.faults, parting.box);
  return std::any_of(crossing.begin(), crossing.end(), [](Crossing c) { return c == Crossing::fault; });
}

/// Sorts the horizon's triangles into blocks and continues each. Where that cannot be done, why; nothing is set then.
std::string part_into_blocks(BuiltSurfaces& built, std::size_t s, const BlockFaults& parting,
                             const RestoredThrow& restored, const BuildLog& log) {
  TriangulatedSurface& surface = built.surfaces[s];
  auto [block, sides] = sort_into_blocks(surface, parting, log, {restored.sheet, restored.before});
  const Index n_blocks = BuiltRows::n_blocks(block);
  if (n_blocks == 0) return ", since all of it does";
  if (lies_in_no_block(surface, block, sides, parting)) return ": no block is given between two of them";
  const bool goes_partly = std::find(block.begin(), block.end(), BuiltRows::of_no_block) != block.end() ||
                           overshoots_an_end(surface, parting);
  if (!extend_blocks(surface, block, parting, log) && goes_partly) return " from blocks that cannot be continued";
  if (n_blocks == 1)
    log.warnings.push_back("horizon " + surface.name +
                           ": all of it lies on one side of the faults across which it is to have throw");
  built.rows.block_of_triangle[s] = std::move(block);
  built.rows.sides_of_block[s] = std::move(sides);
  return "";
}

/// Leaves out the faults that end inside. False where all do, or none.
bool keep_through(std::vector<ThrowFault>& faults, std::vector<std::size_t>& rows, const Box3& box) {
  std::vector<ThrowFault> through;
  std::vector<std::size_t> rows_through;
  for (std::size_t k = 0; k < faults.size(); ++k)
    if (!ends_inside(faults[k], box)) {
      through.push_back(faults[k]);
      rows_through.push_back(rows[k]);
    }
  if (through.empty() || through.size() == faults.size()) return false;
  faults = std::move(through);
  rows = std::move(rows_through);
  return true;
}

/// The blocks of a horizon with throw, each continued on its own.
void build_blocks(BuiltSurfaces& built, std::size_t s, const ModelRules& rules, const BuildLog& log) {
  TriangulatedSurface& surface = built.surfaces[s];
  const SurfaceRules rule = rules.of(s);
  std::vector<ThrowFault> faults;
  std::vector<RampFault> ramps;
  std::vector<std::size_t> rows;
  for (const std::string& name : rule.throw_at) {
    const std::size_t row = throw_fault(built.surfaces, surface, name);
    rows.push_back(row);
    const auto n = static_cast<Index>(built.surfaces[row].triangles.size());
    faults.push_back({&built.surfaces[row], std::min(n, built.rows.first_only_parting[row])});
    const auto stop = std::find_if(built.surfaces.begin(), built.surfaces.end(),
                                   [&](const TriangulatedSurface& t) { return t.name == rules.of(row).stop_at; });
    ramps.push_back({faults.back(), stop == built.surfaces.end() ? nullptr : &*stop});
  }
  const TriangulatedSurface as_given = surface;
  RestoredThrow restored;
  if (rule.cut_smeared) restored = restore_ramps(surface, ramps, built.surfaces, log);
  if (!restored.sheet.empty()) built.rows.n_given_triangles[s] = restored.n_given;
  const bool is_whole = restored.sheet.empty() && stays_whole(surface, faults, *rules.box);
  if (is_whole) {
    log.warnings.push_back("horizon " + surface.name + ": it runs on across " + faults.front().surface->name +
                           " as one sheet, and no throw is restored: it stays as given (give it block by block)");
    if (rule.extend != Extend::none) extend_to_box(surface, rule.extend, *rules.box, log);
    return;
  }
  if (restored.sheet.empty()) rows = leave_out_where_it_runs_on(surface, rows, faults, *rules.box, log);
  if (faults.empty()) {
    if (rule.extend != Extend::none) extend_to_box(surface, rule.extend, *rules.box, log);
    return;
  }
  const auto stays = [&](const std::string& why) {
    surface = as_given;
    built.rows.n_given_triangles[s] = static_cast<Index>(surface.triangles.size());
    log.warnings.push_back("horizon " + surface.name + ": what crosses its faults cannot be made anew" + why +
                           ": it stays as given, and no throw is restored");
    if (rule.extend != Extend::none) extend_to_box(surface, rule.extend, *rules.box, log);
  };
  const Extend how = rule.extend == Extend::none ? Extend::flat : rule.extend;
  std::string why = part_into_blocks(built, s, {faults, how, *rules.box}, restored, log);
  if (!why.empty() && restored.sheet.empty() && keep_through(faults, rows, *rules.box)) {
    log.warnings.push_back("horizon " + surface.name + ": what crosses its faults cannot be made anew" + why +
                           ": no throw is restored at those that end inside");
    surface = as_given;
    why = part_into_blocks(built, s, {faults, how, *rules.box}, restored, log);
  }
  if (!why.empty()) return stays(why);
  built.rows.parted_at[s].assign(rows.begin(), rows.end());
}

}  // namespace

std::vector<TriangulatedSurface> BuiltSurfaces::model_surfaces() const {
  std::vector<TriangulatedSurface> kept = surfaces;
  for (std::size_t s = 0; s < rows.first_only_parting.size(); ++s)
    if (rows.first_only_parting[s] < kept[s].triangles.size()) kept[s].triangles.resize(rows.first_only_parting[s]);
  return kept;
}

BuiltSurfaces build_surfaces(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules,
                             const RunContext& context) {
  BuiltSurfaces built;
  built.surfaces = surfaces;
  built.rows.block_of_triangle.resize(surfaces.size());
  built.rows.sides_of_block.resize(surfaces.size());
  built.rows.parted_at.resize(surfaces.size());
  const BuildLog log{built.notes, built.warnings};
  built.rows.n_given_triangles.reserve(surfaces.size());
  for (const TriangulatedSurface& s : surfaces)
    built.rows.n_given_triangles.push_back(static_cast<Index>(s.triangles.size()));
  warn_of_column_order(surfaces, rules, log);
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
  if (rules.thin_layers == ThinLayers::error && rules.min_thickness > 0) apply_min_thickness(built, rules);
  if (!settle_stack(built, rules) && rules.min_thickness > 0 && rules.thin_layers != ThinLayers::error)
    apply_min_thickness(built, rules);
  return built;
}

}  // namespace geomesh::geomodel
