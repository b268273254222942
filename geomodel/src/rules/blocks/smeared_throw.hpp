// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Horizons that run across a fault as a steep ramp: the throw is restored in place of the ramp.
#pragma once

#include <vector>

#include "rules/extend/extend.hpp"
#include "rules/throw/fault_crossings.hpp"

namespace geomesh::geomodel {

/// A fault of a horizon with throw.
struct RampFault {
  ThrowFault fault;
  const TriangulatedSurface* stop = nullptr;  ///< the surface at which it ends, where there is one
};

/// What became of a horizon whose throw was restored.
struct RestoredThrow {
  std::vector<Index> sheet;  ///< per triangle: those of one number are one sheet, those of
                             ///< BuiltRows::of_every_block go round a fault's end; empty: nothing was done
  Index n_given = 0;         ///< triangles that stayed, which come first
};

/// Takes the ramps out of the horizon and carries what lies beside them across in their place. Each side comes on by
/// planes fitted to its own nodes, as two sheets that overshoot the fault. Nodes and triangles off the ramps stay.
/// Where the horizon crosses a fault without a ramp, it is parted there too. Where a fault ends inside, triangles
/// beyond its end stay and hold both sheets together; from there the throw grows. A fault that ends at another surface
/// counts on the side alone where most of it lies. Notes tell the length and the width of each ramp, and the throw.
/// Nothing is done where there is no ramp. Nor is it, with a warning, where the throw carried is far from the height of
/// the ramp.
RestoredThrow restore_smeared_throw(TriangulatedSurface& horizon, const std::vector<RampFault>& faults,
                                    const std::vector<const TriangulatedSurface*>& others, const BuildLog& log);

}  // namespace geomesh::geomodel
