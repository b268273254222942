// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Settles the stack block by block if its horizons end at walls inside the model.
#pragma once

#include "stack/settle_stack.hpp"
#include "stack/stack_members.hpp"

namespace geomesh::geomodel {

/// False where a horizon truncates faults.
bool can_be_settled_in_blocks(const BuiltSurfaces& built, const ModelRules& rules);

/// In each block, the horizons with their continuations beyond its walls are settled on their own, as settle_stack does
/// over the whole map. The parts beyond the walls are marked separately (BuiltRows::part_of_triangle) and are removed
/// after everything was intersected. A block is left unchanged if it needs no settling, if a horizon has more than one
/// height over a place of the map, or if a horizon ends exactly at a wall, because a horizon that is moved vertically
/// would lose that contact. A note gives the number of blocks left for the last two reasons. Returns whether any block
/// was settled. Cost: as settle_stack, over the contents of each block.
bool settle_in_blocks(const Stack& stack, BuiltSurfaces& built, const ModelRules& rules, const HorizonBlocks& blocks);

}  // namespace geomesh::geomodel
