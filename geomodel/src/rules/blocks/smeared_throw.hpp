// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Replaces steep ramps, by which a horizon runs across a fault, by sharp throw.
#pragma once

#include <vector>

#include "rules/extend/extend.hpp"
#include "rules/throw/fault_crossings.hpp"

namespace geomesh::geomodel {

/// A fault at which a horizon may have a ramp.
struct RampFault {
  ThrowFault fault;
  const TriangulatedSurface* stop = nullptr;  ///< the surface at which the fault ends, if there is one
};

/// Result of restoring the throw of a horizon.
struct RestoredThrow {
  std::vector<Index> sheet;
  Index n_given = 0;  ///< number of given triangles that were kept; they come first
};

/// Removes the ramps from the horizon and extrapolates the surface beside them across the fault. Each side is extended
/// by planes fitted to its own nodes, so that two sheets result which overshoot the fault. Nodes and triangles outside
/// the ramps are kept. If the horizon crosses a fault without a ramp, it is divided there too. If a fault ends inside
/// the model, triangles beyond its tip are kept and connect both sheets; the throw grows from there. For a fault that
/// ends at another surface, only the side is used on which most of the fault lies. Notes report the length and width of
/// each ramp, and the throw. Nothing is done if there is no ramp, or, with a warning, if the extrapolated throw differs
/// much from the height of the ramp.
RestoredThrow restore_smeared_throw(TriangulatedSurface& horizon, const std::vector<RampFault>& faults,
                                    const std::vector<const TriangulatedSurface*>& others, const BuildLog& log);

}  // namespace geomesh::geomodel
