// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The stack is settled in the map before anything is intersected (docs/model-building.md, "The stack").
#pragma once

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/framework/horizon_blocks.hpp"

namespace geomesh::geomodel {

/// Puts the horizons of the column into order, with the topography above and the bottom of the model below. Neighbours
/// share one surface where the unit between is thinner than the least thickness. All get one triangulation of the map
/// with as few triangles as half of the tolerance needs. Where horizons end inside the model, or have several heights
/// over a place of the map, that is done block by block (settle_blocks), if there are `blocks`.
///
/// Gives whether the column was settled. Nothing is done where rules.stack says so or has no tolerance or no size. The
/// same holds where nothing asks for it: horizons in the wrong order without a rule, or that cross at less than 2
/// degrees; units thinner than a least thickness that was given; more than four times the triangles that the size asks
/// for.
bool settle_stack(BuiltSurfaces& built, const ModelRules& rules, const HorizonBlocks* blocks);

}  // namespace geomesh::geomodel
