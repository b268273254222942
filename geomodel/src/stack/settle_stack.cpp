// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/settle_stack.hpp"

#include <algorithm>

#include "stack/horizon_group.hpp"
#include "stack/settle_blocks.hpp"
#include "stack/stack_members.hpp"

namespace geomesh::geomodel {
namespace {

// Margin around a model outline that is not an axis-aligned box, as a fraction of the target size.
constexpr double margin_of_size = 0.25;

/// Returns why the stack cannot be put in order at all, neither block by block nor over the whole map; empty if it can.
std::string obstacle(const Stack& stack) {
  if (stack.rows.size() > most_horizons) return "it has more than " + std::to_string(most_horizons) + " horizons";
  if (stack.rows.size() != stack.units.size() + 1) return "a horizon of the column is not there";
  return "";
}

/// Returns why the stack cannot be put in order over the whole map at once; empty if it can.
std::string obstacle_in_map(const Stack& stack, const BuiltSurfaces& built) {
  for (const Index row : stack.rows) {
    const TriangulatedSurface& s = built.surfaces[row];
    if (!is_single_valued_by_block(s, built.rows.block_of_triangle[row], built.rows.n_given_triangles[row]))
      return "horizon " + s.name + " has more than one height over a place of the map";
  }
  return "";
}

HorizonFaults faults_of(const BuiltSurfaces& built, Index row) {
  HorizonFaults found;
  if (built.rows.block_of_triangle[row].empty()) return found;
  for (const Index s : built.rows.parted_at[row]) {
    const auto n = static_cast<Index>(built.surfaces[s].triangles.size());
    found.faults.push_back({&built.surfaces[s], std::min(n, built.rows.first_only_parting[s])});
    found.rows.push_back(s);
  }
  found.sides = built.rows.sides_of_block[row];
  return found;
}

/// Returns the stack's horizons with their data over the whole map.
GroupMembers members_of(const Stack& stack, const BuiltSurfaces& built, const ModelRules& rules,
                        const MapFrame& frame) {
  GroupMembers members{stack, {}, {}, frame.bounds(rules.stack.outline)};
  if (!rules.stack.outline_is_box) members.bounds = members.bounds.grown(margin_of_size * rules.stack.size);
  for (const Index row : stack.rows) {
    members.data.push_back(block_data(frame.to_frame(built.surfaces[row]), built.rows.block_of_triangle[row],
                                      built.rows.n_given_triangles[row]));
    members.faults.push_back(faults_of(built, row));
  }
  return members;
}

void replace_horizons(HorizonGroup& group, const Stack& stack, BuiltSurfaces& built) {
  for (std::size_t k = 0; k < stack.rows.size(); ++k) {
    const Index row = stack.rows[k];
    SettledHorizon& told = group.told().horizons[k];
    TriangulatedSurface& s = built.surfaces[row];
    told.n_triangles_given = s.triangles.size();
    // Parts beyond bounding surfaces need not be cut off: settled horizons are rebuilt only up to these surfaces.
    built.rows.part_of_triangle[row].clear();
    built.rows.continued_to[row].clear();
    if (group.has_throw(k)) {
      s = group.surface_with_throw(k);
      built.rows.n_given_triangles[row] = group.sided(k).n_single;
      built.rows.block_of_triangle[row] = group.sided(k).block;
    } else {
      s = group.sheet(k);
      built.rows.n_given_triangles[row] = static_cast<Index>(s.triangles.size());
    }
    told.n_triangles = s.triangles.size();
  }
}

bool can_be_ended_on(const TriangulatedSurface& s) {
  return s.kind == SurfaceKind::fault || s.kind == SurfaceKind::body;
}

/// Puts the stack of horizons in order over the whole map, or returns false without a change; `why` is any obstacle.
bool settle_map(const Stack& stack, BuiltSurfaces& built, const ModelRules& rules, bool may_end_inside,
                std::string& why) {
  why = obstacle_in_map(stack, built);
  if (!why.empty()) return false;
  const MapFrame frame(rules.stack.outline, rules.stack.outline_is_box);
  HorizonGroup group(members_of(stack, built, rules, frame), built, rules, frame);
  if (group.ends_inside() && !may_end_inside) {
    why = "a horizon ends inside the model, where faults or bodies may end it (fill_holes, extend)";
    return false;
  }
  const Settling outcome = group.settle();
  if (outcome == Settling::overhangs)
    why = "horizon " + built.surfaces[stack.rows[group.first_that_overhangs()]].name +
          " has more than one height over a place of the map";
  if (outcome != Settling::settled) return false;
  replace_horizons(group, stack, built);
  built.stack = std::move(group.told());
  return true;
}

/// Puts the horizons of the column in order, with topography and base. Returns false if that was not needed, or not
/// possible, which a note explains.
bool settle_column_of(const Stack& stack, BuiltSurfaces& built, const ModelRules& rules, const HorizonBlocks* blocks) {
  if (stack.rows.empty()) return false;
  std::string why = obstacle(stack);
  if (why.empty()) {
    if (blocks && !can_be_settled_in_blocks(stack, built, rules)) blocks = nullptr;
    const bool has_walls = std::any_of(built.surfaces.begin(), built.surfaces.end(), can_be_ended_on);
    if (settle_map(stack, built, rules, !blocks && !has_walls, why)) return true;
    if (why.empty()) return false;
    if (blocks) return settle_in_blocks(stack, built, rules, *blocks);
  }
  built.notes.push_back("the stack is left as given: " + why);
  return false;
}

/// Simplifies horizons that are not in the column but extend through the whole model.
void thin_out_others(const Stack& stack, BuiltSurfaces& built, const ModelRules& rules) {
  for (Index row = 0; row < built.surfaces.size(); ++row) {
    if (built.surfaces[row].kind != SurfaceKind::horizon ||
        std::find(stack.rows.begin(), stack.rows.end(), row) != stack.rows.end())
      continue;
    const Stack alone{{row}, {}, {}};
    if (!built.rows.block_of_triangle[row].empty() || !obstacle_in_map(alone, built).empty()) continue;
    const MapFrame frame(rules.stack.outline, rules.stack.outline_is_box);
    HorizonGroup group(members_of(alone, built, rules, frame), built, rules, frame);
    if (group.ends_inside() || group.settle() != Settling::settled) continue;
    replace_horizons(group, alone, built);
    built.stack.settled = true;
    built.stack.min_thickness = group.told().min_thickness;
    built.stack.horizons.push_back(std::move(group.told().horizons.front()));
  }
}

/// Returns whether the rules request that the stack of horizons is put in order, and give tolerance, size and outline.
bool asks_for_settling(const StackRules& rules) {
  return rules.rule != StackRule::keep && rules.tolerance > 0 && rules.size > 0 && !rules.outline.empty();
}

}  // namespace

bool settle_stack(BuiltSurfaces& built, const ModelRules& rules, const HorizonBlocks* blocks) {
  const StackRules& asked = rules.stack;
  if (!asks_for_settling(asked)) return false;
  const Stack stack = find_stack(built, rules);
  const bool is_settled = settle_column_of(stack, built, rules, blocks);
  thin_out_others(stack, built, rules);
  built.stack.size = asked.size;
  built.stack.tolerance = asked.tolerance;
  return is_settled;
}

}  // namespace geomesh::geomodel
