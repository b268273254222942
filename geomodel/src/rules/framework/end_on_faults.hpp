// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Ends faults on other faults: extends those that stop short, and cuts those that run a little beyond.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/framework/fault_tip.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// The parts removed from a soup: the area by surface, and notes about them.
struct TakenOff {
  std::vector<double>& area;
  std::vector<std::string>& notes;
};

/// Removes what lies beyond the surfaces on which faults end: continuations beyond SurfaceRules::stop_at, where that is
/// in the soup, and beyond walls (end_at_walls), what BuiltRows::overshooting faults have beyond other faults, and
/// faults beyond the unconformities that truncate them, up to the distance of the rules.
void end_faults(WorkingSoup& working, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                const ModelRules& rules, const TakenOff& taken);

/// Walls of blocks intersected with the sides of the model, without the parts outside it.
struct ArrangedWalls {
  std::vector<TriangulatedSurface> surfaces;
  PolygonSoup soup;
};
/// Returns the surfaces of the requested kinds, and the unconformities that truncate faults, cut by each other and by
/// the sides of the model. Requires ContinuationRules::sides.
ArrangedWalls arrange_walls(const BuiltSurfaces& built, const ModelRules& rules, const std::set<SurfaceKind>& kinds);

/// Faults, and the parts of their borders that remain free.
struct EndedFaults {
  std::vector<TriangulatedSurface> surfaces;  ///< the given surfaces, with the faults as end_faults will leave them
  std::vector<FaultTip> tips;
};
/// Determines how faults end from an arrangement of the faults with the sides of the model, since outside the model
/// continuations run around other faults. Sets BuiltRows::overshooting. Faults with a rule for their extent are not
/// cut. Horizons that are continued to the resulting surfaces do not treat a stub beyond a fault as the wall of a
/// block, or the line where two faults meet as a tip.
EndedFaults ended_faults(BuiltSurfaces& built, const ModelRules& rules);

/// Returns whether the fault may be continued and cut by default: no rule determines its extent, and no horizon has
/// throw across it, because its blocks need the whole fault.
bool ends_by_default(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules, Index row);

}  // namespace geomesh::geomodel
