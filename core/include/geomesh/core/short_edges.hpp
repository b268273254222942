// SPDX-License-Identifier: MIT
/// @file
/// Finds edges that are much shorter than the target size, and the features that cause them.
#pragma once

#include "geomesh/core/quality.hpp"

namespace geomesh {

/// Why an edge is short.
enum class EdgeCause {
  free,         ///< nothing forces it
  input_angle,  ///< facets or segments of the input meet at less than 20 degrees at one of its ends
  thin_gap,     ///< the edge lies in a gap between surfaces that is thinner than the limit of short edges
  near_curves,  ///< its ends are on two curves of the input that are so near to each other, or at two ends of curves
  bends,        ///< it is along a curve, which would leave the tolerance without either of its ends
  near_forced,  ///< it is near an edge imposed by the input, from which sizes grow by the gradation
};

struct ShortEdge {
  VertexIndex a = no_vertex, b = no_vertex;
  double length = 0, size = 0;  ///< actual length, and target size at its midpoint
  Vec3 place;                   ///< its middle
  EdgeCause cause = EdgeCause::free;
  double forcing_angle = 0;  ///< the input angle in degrees, if that is the cause
  double gap = 0;            ///< the width of the gap, if that is the cause
};

struct ShortEdges {
  std::size_t n = 0, n_forced = 0;
  std::vector<ShortEdge> worst;  ///< edges without a cause first, then by length divided by size; at most max_worst
};

/// Returns edges shorter than `share` of the target size (`options.size`, which must be set) at their midpoints. The
/// share is a third because, where facets meet at more than 20 degrees, points one size away from the line where they
/// meet are farther apart than that. An edge at a distance d from one that the input imposes, of length f, is excused
/// if its length is at least half of f + gradation * d. O(n), and O(k^2) in the faces at each short edge.
ShortEdges find_short_edges(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                            const QualityOptions& options, double share = 1.0 / 3, std::size_t max_worst = 20);

}  // namespace geomesh
