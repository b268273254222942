// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizons that run across a fault as a steep ramp: the throw is restored in place of the ramp.
#pragma once

#include <vector>

#include "rules/extend.hpp"

namespace geomesh::geomodel {

/// What became of a horizon whose throw was restored.
struct RestoredThrow {
  std::vector<Index> sheet;  ///< per triangle: those of one number are one sheet; empty: nothing was done
  Index n_given = 0;         ///< triangles that stayed, which come first
};

/// Takes the ramps out of the horizon and carries what lies beside them across in their place. Each side comes on by
/// planes fitted to its own nodes, as two sheets that overshoot the fault. Nodes and triangles off the ramps stay. All
/// `faults` must go through the model: where the horizon crosses one without a ramp, it is parted there too. Notes tell
/// the length and the width of each ramp, and the throw. Nothing is done where there is no ramp.
/// Nor is it, with a warning, where the throw carried is far from the height of the ramp.
RestoredThrow restore_smeared_throw(TriangulatedSurface& horizon, const std::vector<const TriangulatedSurface*>& faults,
                                    const std::vector<const TriangulatedSurface*>& others, const BuildLog& log);

}  // namespace geomesh::geomodel
