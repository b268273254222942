// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Replaces ramps, by which a gridded horizon crosses a fault, by sharp throw.
#pragma once

#include <vector>

#include "rules/blocks/throw_blocks.hpp"

namespace geomesh::geomodel {

/// A fault at which a horizon may have a ramp (throw smeared by gridding).
struct RampFault {
  ThrowFault fault;
  const TriangulatedSurface* stop = nullptr;  ///< surface at which the fault ends; null if there is none
};

struct RestoredThrow {
  /// For each triangle, the number of its connected part of the horizon; BuiltRows::of_every_block for triangles around
  /// a fault's tip. Empty if the horizon was not changed.
  std::vector<Index> sheet;
  Index n_given = 0;             ///< number of original triangles of the horizon that were kept; they come first
  std::vector<Triangle> before;  ///< triangles of the horizon before its ramps were removed
};

/// Removes the ramps from the horizon and extrapolates the surface beside them across the fault. Each side is extended
/// by planes fitted to its own nodes, so that two surfaces result which overshoot the fault. Nodes and triangles
/// outside the ramps are kept. If the horizon crosses a fault without a ramp, it is divided there too. If a fault ends
/// inside the model, triangles beyond its tip are kept and connect both sides; the throw grows from there. If a fault
/// ends at another surface, only the side of that surface on which most of the fault lies is used. Notes report the
/// length and width of each ramp, and the throw. Nothing is done if there is no ramp, or, with a warning, if the
/// extrapolated throw differs much from the height of the ramp.
RestoredThrow restore_smeared_throw(TriangulatedSurface& horizon, const std::vector<RampFault>& faults,
                                    const std::vector<const TriangulatedSurface*>& others, const BuildLog& log);

}  // namespace geomesh::geomodel
