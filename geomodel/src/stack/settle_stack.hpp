// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The stack is settled in the map before anything is intersected (docs/model-building.md, "The stack").
#pragma once

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/framework/horizon_blocks.hpp"

namespace geomesh::geomodel {

/// The fault blocks, for a stack that cannot be settled over the whole map at once. All of it outlives its use.
struct StackBlocks {
  const HorizonBlocks& blocks;
  const std::vector<TriangulatedSurface>& continued;  ///< the surfaces with their continuations beyond walls
};

struct SettledRows {
  bool has_column = false;
  std::vector<Index> rows{};  ///< of the surfaces that were made anew
};

/// Puts the horizons of the column into order, with the topography above and the bottom of the model below. Neighbours
/// share one surface where the unit between is thinner than the least thickness. All get one triangulation of the map
/// with as few triangles as half of the tolerance needs. Where horizons end at walls inside the model, or have several
/// heights over a place of the map, that is done block by block (settle_blocks), if `in_blocks` is given.
///
/// Nothing is done where rules.stack says so or has no tolerance or no size. The same holds where nothing asks for it:
/// horizons in the wrong order without a rule, or that cross at less than 2 degrees; units thinner than a least
/// thickness that was given; more than four times the triangles that the size asks for.
///
/// `built`: horizons that are continued end at their walls.
SettledRows settle_stack(BuiltSurfaces& built, const ModelRules& rules, const StackBlocks* in_blocks);
/// False where it is left as given whatever it is.
bool asks_for_settling(const StackRules& rules);

}  // namespace geomesh::geomodel
