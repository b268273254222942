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

/// Record of the parts removed from a soup: the area of each surface, and notes.
struct TakenOff {
  std::vector<double>& area;
  std::vector<std::string>& notes;
};

/// Removes the parts of faults beyond the surfaces on which they end: continuations (end_at_walls), parts of the faults
/// in BuiltRows::overshooting beyond other faults, and parts of faults beyond unconformities, up to `within` (m).
void end_faults(WorkingSoup& working, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                double within, const TakenOff& taken);

/// The bounding surfaces of fault blocks, intersected with the sides of the model and without the parts outside it.
struct ArrangedWalls {
  /// The built surfaces, followed by the sides of the model; surfaces that were not requested have no triangles.
  std::vector<TriangulatedSurface> surfaces;
  PolygonSoup soup;
};
/// Returns the surfaces of the requested kinds, and the unconformities that truncate faults, cut by each other and by
/// the sides of the model. Requires ContinuationRules::sides.
ArrangedWalls arrange_walls(const BuiltSurfaces& built, const ModelRules& rules, const std::set<SurfaceKind>& kinds);

/// Faults after the parts that overshoot other faults were cut off, and the edges at which faults end inside the model.
struct EndedFaults {
  std::vector<TriangulatedSurface> surfaces;  ///< all surfaces; those of faults end where other faults truncate them
  std::vector<FaultTip> tips;
};
/// Determines where faults end, from an arrangement of the faults with the sides of the model, because outside the
/// model continuations run around other faults. Sets BuiltRows::overshooting. Faults with a rule for their extent are
/// not cut. When horizons are continued to the resulting surfaces, a stub of a fault beyond another fault is no
/// bounding surface of a block, and the line where two faults meet is no tip.
EndedFaults ended_faults(BuiltSurfaces& built, const ModelRules& rules);

/// Returns whether the fault may be continued and cut by default: no rule determines its extent, and no horizon has
/// throw across it. The blocks of a horizon with throw need the whole fault.
bool ends_by_default(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules, Index row);

}  // namespace geomesh::geomodel
