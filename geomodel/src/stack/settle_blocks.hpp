// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Settles a stack of horizons (puts it in order) block by block, if horizons end at surfaces inside the model.
#pragma once

#include "stack/settle_stack.hpp"
#include "stack/stack_members.hpp"

namespace geomesh::geomodel {

/// Returns whether the stack can be put in order block by block. It cannot if a horizon has throw by rule, and
/// therefore its own blocks, or if a horizon truncates faults.
bool can_be_settled_in_blocks(const Stack& stack, const BuiltSurfaces& built, const ModelRules& rules);

/// Puts the horizons of each fault block in order, with their continuations beyond the surfaces that bound it, as
/// settle_stack() does over the whole map. The parts beyond the bounding surfaces are marked
/// (BuiltRows::part_of_triangle) and removed after the intersection of all surfaces. Nothing is changed if in any block
/// a horizon has more than one height over a place of the map, or ends exactly at a bounding surface, because moving it
/// vertically would break that contact; a note gives the number of such blocks. Returns whether any block was changed.
/// Cost: as settle_stack(), over the contents of each block.
bool settle_in_blocks(const Stack& stack, BuiltSurfaces& built, const ModelRules& rules, const HorizonBlocks& blocks);

}  // namespace geomesh::geomodel
