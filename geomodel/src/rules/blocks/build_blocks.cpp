// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/blocks/build_blocks.hpp"

#include <algorithm>

#include "geomesh/core/error.hpp"
#include "rules/blocks/smeared_throw.hpp"
#include "rules/blocks/throw_blocks.hpp"

namespace geomesh::geomodel {
namespace {

/// The faults that divide a horizon into blocks, and the indices of their surfaces.
struct PartingFaults {
  std::vector<ThrowFault> faults{};
  std::vector<Index> rows{};
  void add(const ThrowFault& fault, Index row) {
    faults.push_back(fault);
    rows.push_back(row);
  }
};

RestoredThrow restore_ramps(TriangulatedSurface& horizon, const std::vector<RampFault>& faults,
                            const std::vector<TriangulatedSurface>& surfaces, const BuildLog& log) {
  std::vector<const TriangulatedSurface*> others;
  for (const TriangulatedSurface& surface : surfaces)
    if (surface.kind == SurfaceKind::fault &&
        std::none_of(faults.begin(), faults.end(), [&](const RampFault& f) { return f.fault.surface == &surface; }))
      others.push_back(&surface);
  return restore_smeared_throw(horizon, faults, others, log);
}

std::vector<const TriangulatedSurface*> surfaces_of(const std::vector<ThrowFault>& faults) {
  std::vector<const TriangulatedSurface*> surfaces;
  for (const ThrowFault& fault : faults) surfaces.push_back(fault.surface);
  return surfaces;
}

/// Returns the faults across which the horizon may have a ramp. Faults between two separate parts of the horizon are
/// excluded, because a grid that smears throw connects both sides.
std::vector<RampFault> without_parted(const std::vector<RampFault>& ramps, const TriangulatedSurface& horizon,
                                      const PartingFaults& parting) {
  const std::vector<bool> parts = parting_of(horizon, surfaces_of(parting.faults));
  std::vector<RampFault> left;
  for (std::size_t k = 0; k < ramps.size(); ++k)
    if (!parts[k]) left.push_back(ramps[k]);
  return left;
}

/// Returns whether the fault divides the horizon completely, so that the horizon does not continue around its end.
bool goes_through(const ThrowFault& fault, const TriangulatedSurface& horizon, const Box3& box) {
  if (fault.first_made == fault.surface->triangles.size()) return true;
  const std::vector<Crossing> crossing = find_crossings(horizon, 0, {fault}, box);
  return std::none_of(crossing.begin(), crossing.end(), [](Crossing c) { return c == Crossing::continuation; });
}

/// Drops those faults through the whole model across which a connected part of the horizon continues, with a warning.
/// The horizon has no throw there, and dividing it would remove the area beyond the fault.
void leave_out_where_it_runs_on(const TriangulatedSurface& horizon, PartingFaults& parting, const Box3& box,
                                const BuildLog& log) {
  const std::vector<bool> runs_on = SheetSides(horizon, surfaces_of(parting.faults)).run_across();
  PartingFaults kept;
  std::vector<std::string> left_out;
  for (std::size_t k = 0; k < runs_on.size(); ++k) {
    if (runs_on[k] && goes_through(parting.faults[k], horizon, box))
      left_out.push_back(parting.faults[k].surface->name);
    else
      kept.add(parting.faults[k], parting.rows[k]);
  }
  for (const std::string& name : left_out)
    log.warnings.push_back(
        "horizon " + horizon.name + ": it runs on across " + name + " as one sheet, " +
        (kept.faults.empty() ? "and no throw is restored: it is kept as given" : "so that it has no throw there") +
        " (give it block by block)");
  parting = std::move(kept);
}

/// Returns whether triangles of the horizon cross a fault, and some fault ends inside the model. The parts of such
/// triangles beyond the fault need not belong to another block.
bool overshoots_an_end(const TriangulatedSurface& horizon, const BlockFaults& parting) {
  if (std::none_of(parting.faults.begin(), parting.faults.end(),
                   [&](const ThrowFault& f) { return ends_inside(f, parting.box); }))
    return false;
  const std::vector<Crossing> crossing = find_crossings(horizon, 0, parting.faults, parting.box);
  return std::any_of(crossing.begin(), crossing.end(), [](Crossing c) { return c == Crossing::fault; });
}

/// Assigns the horizon's triangles to blocks and extends each block. If that fails, returns the reason and changes
/// nothing.
std::string part_into_blocks(BuiltSurfaces& built, std::size_t s, const BlockFaults& parting,
                             const RestoredThrow& restored, const BuildLog& log) {
  TriangulatedSurface& surface = built.surfaces[s];
  SortedBlocks sorted = sort_into_blocks(surface, parting, log, {restored.sheet, restored.before});
  std::vector<Index>& block = sorted.of_triangle;
  const Index n_blocks = BuiltRows::n_blocks(block);
  if (n_blocks == 0) return ", since all of it does";
  if (lies_in_no_block(surface, block, sorted.sides, parting)) return ": no block is given between two of them";
  const bool goes_partly = std::find(block.begin(), block.end(), BuiltRows::of_no_block) != block.end() ||
                           overshoots_an_end(surface, parting);
  if (!extend_blocks(surface, sorted, parting, log) && goes_partly) return " from blocks that cannot be continued";
  if (n_blocks == 1)
    log.warnings.push_back("horizon " + surface.name +
                           ": all of it lies on one side of the faults across which it is to have throw");
  built.rows.block_of_triangle[s] = std::move(block);
  built.rows.sides_of_block[s] = std::move(sorted.sides);
  return "";
}

/// Keeps only those dividing faults that do not end in the model. Returns false, without a change, if none or all do.
bool keep_through(PartingFaults& parting, const Box3& box) {
  PartingFaults through;
  for (std::size_t k = 0; k < parting.faults.size(); ++k)
    if (!ends_inside(parting.faults[k], box)) through.add(parting.faults[k], parting.rows[k]);
  if (through.faults.empty() || through.faults.size() == parting.faults.size()) return false;
  parting = std::move(through);
  return true;
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

void build_blocks(BuiltSurfaces& built, std::size_t s, const ModelRules& rules, const BuildLog& log) {
  TriangulatedSurface& surface = built.surfaces[s];
  const SurfaceRules rule = rules.of(s);
  PartingFaults parting;
  std::vector<RampFault> ramps;
  for (const std::string& name : rule.throw_at) {
    const std::size_t row = throw_fault(built.surfaces, surface, name);
    const auto n = static_cast<Index>(built.surfaces[row].triangles.size());
    parting.add({&built.surfaces[row], std::min(n, built.rows.first_only_parting[row])}, static_cast<Index>(row));
    const auto stop = std::find_if(built.surfaces.begin(), built.surfaces.end(),
                                   [&](const TriangulatedSurface& t) { return t.name == rules.of(row).stop_at; });
    ramps.push_back({parting.faults.back(), stop == built.surfaces.end() ? nullptr : &*stop});
  }
  const TriangulatedSurface as_given = surface;
  RestoredThrow restored;
  if (rule.cut_smeared) {
    const std::vector<RampFault> may_be_smeared = without_parted(ramps, surface, parting);
    if (!may_be_smeared.empty()) restored = restore_ramps(surface, may_be_smeared, built.surfaces, log);
  }
  const bool has_ramps = !restored.sheet.empty();
  if (has_ramps) built.rows.n_given_triangles[s] = restored.n_given;
  if (!has_ramps) leave_out_where_it_runs_on(surface, parting, *rules.box, log);
  const auto part = [&] {
    const Extend how = rule.extend == Extend::none ? Extend::flat : rule.extend;
    return part_into_blocks(built, s, {parting.faults, how, *rules.box}, restored, log);
  };
  std::string why = parting.faults.empty() ? "" : part();
  const auto tell = [&](const std::string& what) {
    log.warnings.push_back("horizon " + surface.name + ": what crosses its faults cannot be made anew" + why + ": " +
                           what);
    surface = as_given;
  };
  if (!why.empty() && !has_ramps && keep_through(parting, *rules.box)) {
    tell("no throw is restored at those that end inside");
    why = part();
  }
  if (!why.empty()) {
    tell("it is kept as given, and no throw is restored");
    built.rows.n_given_triangles[s] = static_cast<Index>(surface.triangles.size());
    parting = {};
  }
  built.rows.parted_at[s] = parting.rows;
  if (parting.faults.empty() && rule.extend != Extend::none) extend_to_box(surface, rule.extend, *rules.box, log);
}

}  // namespace geomesh::geomodel
