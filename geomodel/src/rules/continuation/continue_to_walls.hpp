// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Continues surfaces that stop a little short of the surfaces that bound them: faults to other faults and to the sides
/// of the model, horizons to those, to bodies and to other horizons. This is the default; `extend: none` and `extent:
/// as_given` keep borders open.
#pragma once

#include <optional>

#include "rules/extend/extend.hpp"
#include "rules/framework/horizon_blocks.hpp"

namespace geomesh::geomodel {

/// Continues faults that have no rule for their extent, over at most ContinuationRules::within_of_faults. A fault keeps
/// its tip inside the model if every surface on which it could end is farther away.
void continue_faults(BuiltSurfaces& built, const ModelRules& rules, const BuildLog& log);

/// Returns the distance in m over which a horizon may be continued: through the whole model if it fills its blocks.
double reach_of_horizon(const ContinuationRules& rules, bool fills_blocks);

/// Continues the horizons that have neither `extend` nor throw by at most the distance
/// ContinuationRules::within_of_horizons. Gaps in them that no fault or body explains are filled first. The horizons
/// with indices in `fill_blocks` are continued through the whole of each fault block in which they have data. Returns
/// the fault blocks if they had to be computed.
std::optional<HorizonBlocks> continue_horizons(BuiltSurfaces& built, const ModelRules& rules,
                                               const std::vector<Index>& fill_blocks, const BuildLog& log);

}  // namespace geomesh::geomodel
