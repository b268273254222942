// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The stack settled block by block, where its horizons end at walls inside the model.
#pragma once

#include "stack/settle_stack.hpp"
#include "stack/stack_members.hpp"

namespace geomesh::geomodel {

/// False where a horizon truncates faults.
bool can_be_settled_in_blocks(const BuiltSurfaces& built, const ModelRules& rules);

/// In each block the horizons with their continuations beyond its walls are settled by themselves, as settle_stack does
/// it over the map. What lies beyond the walls is a part of its own (BuiltRows::part_of_triangle), which is removed
/// once all is intersected. A block stays as it is where nothing asks for settling, where a horizon has more than one
/// height over a place of the map, and where one ends exactly at a wall: a horizon that is moved along the vertical
/// would no longer meet it.
/// A note counts the blocks that are left for the last two reasons.
///
/// Gives whether any block was settled. Cost: as settle_stack, over what each block has.
bool settle_in_blocks(const Stack& stack, BuiltSurfaces& built, const ModelRules& rules, const HorizonBlocks& blocks);

}  // namespace geomesh::geomodel
