// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Settles the stack of horizons in the map before anything is intersected (docs/model-building.md, "The stack").
#pragma once

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/framework/horizon_blocks.hpp"

namespace geomesh::geomodel {

/// Puts the horizons of the column into order, with the topography above and the base of the model below. Neighbours
/// are merged where the unit between them is thinner than the least thickness. All horizons get one triangulation of
/// the map, with as few triangles as half of the tolerance allows. If horizons end inside the model, or have several
/// heights over a place of the map, this is done block by block (settle_blocks), provided there are `blocks`. Returns
/// whether the column was settled. Nothing is done if rules.stack forbids it or has no tolerance or size, or if there
/// is no need. Needs are: horizons in the wrong order without a rule, or crossing at less than 2 degrees; units thinner
/// than a given least thickness; more than four times the triangles that the target size requires.
bool settle_stack(BuiltSurfaces& built, const ModelRules& rules, const HorizonBlocks* blocks);

}  // namespace geomesh::geomodel
