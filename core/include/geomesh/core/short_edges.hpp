// SPDX-License-Identifier: MIT
/// @file
/// Edges that are much shorter than asked, and what forces them.
#pragma once

#include "geomesh/core/quality.hpp"

namespace geomesh {

/// Why an edge is short.
enum class EdgeCause {
  free,         ///< nothing forces it
  input_angle,  ///< at one of its ends facets or segments of the input meet at less than 20 degrees
  thin_gap,     ///< it is in a gap thinner than the edges that count as short
  near_curves,  ///< its ends are on two curves of the input, or are two ends of curves, that are so near to each other
  bends,        ///< it is along a curve, which would leave the tolerance without either of its ends
  near_forced,  ///< sizes that grow by the gradation from an edge that the input forces are short there too
};

struct ShortEdge {
  VertexIndex a = no_vertex, b = no_vertex;
  double length = 0, size = 0;  ///< as it is, and as it is asked at its middle
  Vec3 place;                   ///< its middle
  EdgeCause cause = EdgeCause::free;
  double forcing_angle = 0;  ///< degrees, where that is the cause
  double gap = 0;            ///< the gap's width, where that is the cause
};

struct ShortEdges {
  std::size_t n = 0, n_forced = 0;
  std::vector<ShortEdge> worst;  ///< those that nothing forces first, then by length over size; at most max_worst
};

/// Edges shorter than `share` of the asked size (`options.size`, which must be there) at their middles. A third: where
/// facets meet at more than 20 degrees, parts that stand one size apart from where they meet are farther from each
/// other than that. An edge is near a forced one, of length f at a distance d, where it is at least half of
/// f + gradation * d. O(n), and O(k^2) in the faces at each short edge.
ShortEdges find_short_edges(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                            const QualityOptions& options, double share = 1.0 / 3, std::size_t max_worst = 20);

}  // namespace geomesh
