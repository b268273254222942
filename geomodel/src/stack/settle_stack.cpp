// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/settle_stack.hpp"

#include <algorithm>

#include "rules/continuation/continue_to_walls.hpp"
#include "rules/planar/single_valued.hpp"
#include "stack/horizon_group.hpp"
#include "stack/settle_blocks.hpp"
#include "stack/stack_members.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double margin_of_size = 0.25;

/// Returns why the stack cannot be settled, in blocks or not; empty if it can.
std::string obstacle(const Stack& stack) {
  if (stack.rows.size() > most_horizons) return "it has more than " + std::to_string(most_horizons) + " horizons";
  if (stack.rows.size() != stack.units.size() + 1) return "a horizon of the column is not there";
  return "";
}

/// Returns why the stack cannot be settled over the whole map at once.
std::string obstacle_in_map(const Stack& stack, const BuiltSurfaces& built) {
  for (const Index row : stack.rows) {
    const TriangulatedSurface& s = built.surfaces[row];
    if (!is_single_valued(s)) return "horizon " + s.name + " has more than one height over a place of the map";
  }
  return "";
}

/// Returns the stack's horizons with their data over the whole map.
GroupMembers members_of(const Stack& stack, const BuiltSurfaces& built, const ModelRules& rules,
                        const MapFrame& frame) {
  GroupMembers members{stack, {}, frame.bounds(rules.stack.outline)};
  if (!rules.stack.outline_is_box) members.bounds = members.bounds.grown(margin_of_size * rules.stack.size);
  for (const Index row : stack.rows) members.data.push_back(frame.to_frame(built.surfaces[row]));
  return members;
}

void replace_horizons(HorizonGroup& group, const Stack& stack, BuiltSurfaces& built) {
  for (std::size_t k = 0; k < stack.rows.size(); ++k) {
    const Index row = stack.rows[k];
    SettledHorizon& told = group.told().horizons[k];
    TriangulatedSurface& s = built.surfaces[row];
    told.n_triangles_given = s.triangles.size();
    built.rows.part_of_triangle[row].clear();  // settled horizons are rebuilt up to their walls
    built.rows.continued_to[row].clear();
    built.rows.block_of_triangle[row].clear();
    s = group.sheet(k);
    built.rows.n_given_triangles[row] = static_cast<Index>(s.triangles.size());
    told.n_triangles = s.triangles.size();
  }
}

bool can_be_ended_on(const TriangulatedSurface& s) {
  return s.kind == SurfaceKind::fault || s.kind == SurfaceKind::body;
}

/// Settles the stack over the whole map. If it does not, `why` gives the obstacle; it is empty if nothing had to be
/// done.
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

/// Settles the column together with the topography and the base. Returns false if nothing had to be settled or if it
/// was not possible, which a note explains.
bool settle_column_of(const Stack& stack, BuiltSurfaces& built, const ModelRules& rules, const HorizonBlocks* blocks) {
  if (stack.rows.empty()) return false;
  std::string why = obstacle(stack);
  if (why.empty()) {
    const bool may_be_in_blocks = can_be_settled_in_blocks(built, rules);
    if (!may_be_in_blocks) blocks = nullptr;
    const bool has_walls = std::any_of(built.surfaces.begin(), built.surfaces.end(), can_be_ended_on);
    if (settle_map(stack, built, rules, !blocks && !has_walls, why)) return true;
    if (why.empty()) return false;
    if (blocks) return settle_in_blocks(stack, built, rules, *blocks);
    const auto has_throw = [&](Index row) { return !built.rows.parted_at[row].empty(); };
    const bool any_has_throw = std::ranges::any_of(stack.rows, has_throw);
    if (may_be_in_blocks && any_has_throw) return settle_in_blocks(stack, built, rules, blocks_of_model(built, rules));
    if (any_has_throw)
      why += built.rows.truncations.empty() ? "; it is not settled in fault blocks where continue_within is 0"
                                            : "; it is not settled in fault blocks where a horizon truncates faults";
  }
  built.notes.push_back("the stack is left as given: " + why);
  return false;
}

/// Simplifies horizons that are not in the column but reach through the model.
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

/// Returns false if the rules leave the stack as given in any case.
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
