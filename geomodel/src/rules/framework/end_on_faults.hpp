// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Faults that end on other faults: continued up to them where they stop short, cut there where they run a little
/// beyond.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/framework/fault_tip.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

/// What was taken off a soup: the area by surface, and what is told of it.
struct TakenOff {
  std::vector<double>& area;
  std::vector<std::string>& notes;
};

/// Removes what lies beyond the surfaces on which faults end: continuations beyond SurfaceRules::stop_at, where that is
/// in the soup, and beyond walls (end_at_walls), what BuiltRows::overshooting faults have beyond other faults, and
/// faults beyond the unconformities that truncate them, up to the distance of the rules.
void end_faults(WorkingSoup& working, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                const ModelRules& rules, const TakenOff& taken);

/// Walls of blocks intersected with the sides of the model; what lies outside of it is left out.
struct ArrangedWalls {
  std::vector<TriangulatedSurface> surfaces;  ///< those built, without triangles where not asked for; then the sides
  PolygonSoup soup;
};
/// Surfaces of the kinds asked for, and the unconformities that truncate faults, cut by each other and by the sides of
/// the model. Expects ContinuationRules::sides.
ArrangedWalls arrange_walls(const BuiltSurfaces& built, const ModelRules& rules, const std::set<SurfaceKind>& kinds);

/// Faults and what is left of their borders.
struct EndedFaults {
  std::vector<TriangulatedSurface> surfaces;  ///< those given, with the faults as end_faults will leave them
  std::vector<FaultTip> tips;
};
/// From an arrangement of the faults with the sides of the model: outside of it continuations go round other faults.
/// Sets BuiltRows::overshooting. Faults with a rule of their own for their extent are not cut. Horizons that are
/// continued to these surfaces do not take a stub beyond a fault for the wall of a block, nor the line where two faults
/// meet for a tip.
EndedFaults ended_faults(BuiltSurfaces& built, const ModelRules& rules);

/// Whether the fault may be continued and cut by default: no rule tells its extent, and no horizon has throw across it,
/// whose blocks need the fault whole.
bool ends_by_default(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules, Index row);

}  // namespace geomesh::geomodel
