// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Settles the stack: puts its horizons in order before any intersection (docs/model-building.md, "The stack").
#pragma once

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/framework/horizon_blocks.hpp"

namespace geomesh::geomodel {

/// Puts the horizons of the column into order, with the topography above and the base of the model below. Neighbours
/// are merged where the unit between them is thinner than the least thickness. All horizons get one common
/// triangulation of the map, with as few triangles as half of the tolerance allows. If horizons end inside the model,
/// or have several heights over a place of the map, this is done block by block (settle_in_blocks), provided that
/// `blocks` is not null. Returns whether the column was changed. Nothing is done if rules.stack forbids it or has no
/// tolerance or size, or if there is no need. It is needed if horizons are in the wrong order without a rule, or cross
/// at less than 2 degrees; if units are thinner than a given least thickness; or if there are more than four times the
/// triangles that the target size requires.
bool settle_stack(BuiltSurfaces& built, const ModelRules& rules, const HorizonBlocks* blocks);

}  // namespace geomesh::geomodel
