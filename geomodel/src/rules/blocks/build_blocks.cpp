// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/blocks/build_blocks.hpp"

#include <algorithm>

#include "geomesh/core/error.hpp"
#include "naming/region_facts.hpp"
#include "naming/sums.hpp"
#include "rules/blocks/smeared_throw.hpp"
#include "rules/blocks/throw_blocks.hpp"
#include "rules/continuation/continue_to_walls.hpp"
#include "rules/extend/fault_ends.hpp"
#include "rules/throw/sheets.hpp"

namespace geomesh::geomodel {
namespace {

/// The faults that divide a horizon into blocks, and the rows of their surfaces.
struct PartingFaults {
  std::vector<ThrowFault> faults{};
  std::vector<Index> rows{};
  void add(const ThrowFault& fault, Index row) {
    faults.push_back(fault);
    rows.push_back(row);
  }
};

/// Replaces the ramps of a horizon across the faults by sharp throw.
RestoredThrow restore_ramps(TriangulatedSurface& horizon, const std::vector<RampFault>& faults,
                            const std::vector<TriangulatedSurface>& surfaces, const BuildLog& log) {
  std::vector<const TriangulatedSurface*> others;
  for (const TriangulatedSurface& surface : surfaces)
    if (surface.kind == SurfaceKind::fault &&
        std::none_of(faults.begin(), faults.end(), [&](const RampFault& f) { return f.fault.surface == &surface; }))
      others.push_back(&surface);
  return restore_smeared_throw(horizon, faults, others, log);
}

/// Returns the faults across which the horizon may have a ramp. A fault between two separate sheets is none of them,
/// because a grid that smears throw connects both sides.
std::vector<RampFault> that_may_be_smeared(const std::vector<RampFault>& ramps, const TriangulatedSurface& horizon) {
  std::vector<RampFault> left;
  for (const RampFault& ramp : ramps) {
    TriangulatedSurface given = *ramp.fault.surface;
    given.triangles.resize(ramp.fault.first_made);
    if (runs_across(horizon, given)) left.push_back(ramp);
  }
  return left;
}

/// The blocks of all faults of the model, as if each went on through it: sheets on both sides of a fault that the list
/// lacks are not in one block.
const BlockFramework& framework_of_faults(BuiltSurfaces& built, const ModelRules& rules, std::size_t horizon) {
  std::vector<Index> faults;
  for (Index s = 0; s < built.surfaces.size(); ++s)
    if (built.surfaces[s].kind == SurfaceKind::fault && !built.surfaces[s].triangles.empty()) faults.push_back(s);
  if (built.rows.parted_at[horizon] == faults) return built.rows.throw_blocks[horizon]->framework;
  if (!built.rows.blocks_of_faults) {
    BuiltSurfaces continued = built;
    for (const Index s : faults) {
      if (built.rows.first_only_parting[s] != no_index) continue;
      continue_fault(continued.surfaces[s], *rules.box, *rules.box);
      if (std::vector<Index>& part = continued.rows.part_of_triangle[s]; !part.empty())
        part.resize(continued.surfaces[s].triangles.size(), 0);
    }
    built.rows.blocks_of_faults = blocks_between(continued, rules, faults);
  }
  return built.rows.blocks_of_faults->framework;
}

/// Sets the blocks of the horizon's triangles and removes what overshoots its faults. Says so.
void sort_triangles(BuiltSurfaces& built, std::size_t row, const PartingFaults& parting, const RestoredThrow& restored,
                    const ModelRules& rules, const BuildLog& log) {
  const SortedTriangles sorted =
      sort_into_blocks(built.surfaces[row], restored.sheet,
                       {parting.faults, built.rows.throw_blocks[row]->framework, *rules.box,
                        [&]() -> const BlockFramework& { return framework_of_faults(built, rules, row); }});
  TriangulatedSurface& horizon = built.surfaces[row];
  std::vector<Index>& block = built.rows.block_of_triangle[row];
  std::vector<Triangle> kept;
  Index n_given = 0;
  double area = 0, largest = 0;
  Vec3 place;
  for (Index t = 0; t < horizon.triangles.size(); ++t) {
    if (!sorted.overshoots[t]) {
      n_given += t < built.rows.n_given_triangles[row];
      block.push_back(sorted.block[t]);
      kept.push_back(horizon.triangles[t]);
      continue;
    }
    if (t >= built.rows.n_given_triangles[row]) continue;
    area += area_of(horizon, t);
    if (area_of(horizon, t) > largest) largest = area_of(horizon, t), place = centre_of(horizon, horizon.triangles[t]);
  }
  horizon.triangles = std::move(kept);
  built.rows.n_given_triangles[row] = n_given;
  if (area > 0)
    log.notes.push_back("horizon " + horizon.name + ": given beyond its faults (overshoot on the wrong side), area " +
                        to_text(area) + " near " + to_text(place) + ", removed");
  for (std::size_t f = 0; f < parting.faults.size(); ++f)
    if (sorted.runs_across[f] && restored.sheet.empty())
      log.warnings.push_back("horizon " + horizon.name + ": it runs on across " + parting.faults[f].surface->name +
                             " as one sheet, so that it has no throw there (give it block by block)");
}

}  // namespace

std::size_t throw_fault(const std::vector<TriangulatedSurface>& surfaces, const TriangulatedSurface& horizon,
                        const std::string& name) {
  const auto fault =
      std::find_if(surfaces.begin(), surfaces.end(), [&](const TriangulatedSurface& s) { return s.name == name; });
  if (fault == surfaces.end())
    throw Error(ErrorKind::usage, "horizon " + horizon.name + ": throw_at names " + name + ", which is no surface");
  return static_cast<std::size_t>(fault - surfaces.begin());
}

void set_throw_blocks(BuiltSurfaces& built, Index row, const ModelRules& rules) {
  std::vector<Index> faults;
  for (const std::string& name : rules.of(row).throw_at)
    faults.push_back(static_cast<Index>(throw_fault(built.surfaces, built.surfaces[row], name)));
  std::ranges::sort(faults);
  faults.erase(std::unique(faults.begin(), faults.end()), faults.end());
  for (Index s = 0; s < built.rows.parted_at.size() && !built.rows.throw_blocks[row]; ++s)
    if (built.rows.parted_at[s] == faults) built.rows.throw_blocks[row] = built.rows.throw_blocks[s];
  if (!built.rows.throw_blocks[row]) built.rows.throw_blocks[row] = blocks_between(built, rules, faults);
  built.rows.parted_at[row] = std::move(faults);
}

void build_blocks(BuiltSurfaces& built, std::size_t s, const ModelRules& rules, const BuildLog& log) {
  TriangulatedSurface& surface = built.surfaces[s];
  PartingFaults parting;
  std::vector<RampFault> ramps;
  for (const std::string& name : rules.of(s).throw_at) {
    const std::size_t row = throw_fault(built.surfaces, surface, name);
    const auto n = static_cast<Index>(built.surfaces[row].triangles.size());
    parting.add({&built.surfaces[row], std::min(n, built.rows.first_only_parting[row])}, static_cast<Index>(row));
    const auto stop = std::find_if(built.surfaces.begin(), built.surfaces.end(),
                                   [&](const TriangulatedSurface& t) { return t.name == rules.of(row).stop_at; });
    ramps.push_back({parting.faults.back(), stop == built.surfaces.end() ? nullptr : &*stop});
  }
  RestoredThrow restored;
  if (rules.of(s).cut_smeared) {
    const std::vector<RampFault> may_be_smeared = that_may_be_smeared(ramps, surface);
    if (!may_be_smeared.empty()) restored = restore_ramps(surface, may_be_smeared, built.surfaces, log);
  }
  if (!restored.sheet.empty()) built.rows.n_given_triangles[s] = restored.n_given;
  set_throw_blocks(built, static_cast<Index>(s), rules);
  sort_triangles(built, s, parting, restored, rules, log);
  fill_throw_blocks(built, static_cast<Index>(s), rules, log);
}

}  // namespace geomesh::geomodel
