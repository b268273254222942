// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Continues surfaces that stop a little short of what bounds them: faults to other faults and to the sides of the
/// model, horizons to those, to bodies and to other horizons. This is the default; `extend: none` and `extent:
/// as_given` keep borders open.
#pragma once

#include <optional>

#include "rules/extend/extend.hpp"
#include "rules/framework/horizon_blocks.hpp"

namespace geomesh::geomodel {

/// Continues faults without an extent of their own, over at most ContinuationRules::within_of_faults. A fault that ends
/// inside the model farther from everything on which it could end keeps its tip.
void continue_faults(BuiltSurfaces& built, const ModelRules& rules, const BuildLog& log);

/// A horizon sorted into the blocks of the faults across which it has throw (BuiltRows::throw_blocks): it fills each of
/// those in which it has data. Sets the blocks of what it adds.
void fill_throw_blocks(BuiltSurfaces& built, Index row, const ModelRules& rules, const BuildLog& log);

/// How far from its data a horizon with a list of faults keeps its slope, m: as SurfaceRules::extend says, else within
/// the distance.
double reach_of_slope(const ModelRules& rules, Index row, double within);

/// Returns how far a horizon is continued to find walls, in m; a horizon that fills its blocks is continued through the
/// whole model.
double reach_of_horizon(const ContinuationRules& rules, bool fills_blocks);

/// Continues horizons without `extend` and without throw, over at most ContinuationRules::within_of_horizons. Gaps in
/// them that no fault or body explains are filled first. Horizons of these rows fill each block in which they have
/// data. Returns the blocks, if any were needed.
std::optional<HorizonBlocks> continue_horizons(BuiltSurfaces& built, const ModelRules& rules,
                                               const std::vector<Index>& fill_blocks, const BuildLog& log);

/// The blocks of all faults and bodies, for horizons that were continued by lists of faults alone.
HorizonBlocks blocks_of_model(const BuiltSurfaces& built, const ModelRules& rules);

}  // namespace geomesh::geomodel
