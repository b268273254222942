// SPDX-License-Identifier: MIT
/// @file
/// Finds edges that are much shorter than the target size, and the features that cause them.
#pragma once

#include "geomesh/core/quality.hpp"

namespace geomesh {

/// Why an edge is short.
enum class EdgeCause {
  free,         ///< no feature of the input imposes the short edge
  input_angle,  ///< facets or segments of the input meet at less than 20 degrees at an end of the edge
  thin_gap,     ///< the edge lies in a gap between surfaces that is thinner than the limit of short edges
  near_curves,  ///< the edge connects two curves of the input that are close to each other, or two ends of curves
  bends,        ///< the edge is on a curve that would leave the tolerance if either end were removed
  near_forced,  ///< the edge is near a short edge that the input imposes, from which sizes grow by the gradation
};

struct ShortEdge {
  VertexIndex a = no_vertex, b = no_vertex;
  double length = 0, size = 0;  ///< length of the edge, and target size at its midpoint
  Vec3 place;                   ///< its middle
  EdgeCause cause = EdgeCause::free;
  double forcing_angle = 0;  ///< the small angle of the input in degrees, if `cause` is input_angle
  double gap = 0;            ///< width of the gap, if `cause` is thin_gap
};

struct ShortEdges {
  std::size_t n = 0, n_forced = 0;
  std::vector<ShortEdge> worst;  ///< short edges, those without a cause first, then by length / size; at most max_worst
};

/// Returns edges shorter than `share` of the target size (`options.size`, which must be set) at their midpoints. The
/// default is a third, because points of two facets that meet at more than 20 degrees are farther apart than that at a
/// distance of one size from the line in which the facets meet. An edge at a distance d from one that the input
/// imposes, of length f, is excused if its length is at least half of f + gradation * d. Takes O(n) time, and O(k^2)
/// for k faces at a short edge.
ShortEdges find_short_edges(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                            const QualityOptions& options, double share = 1.0 / 3, std::size_t max_worst = 20);

}  // namespace geomesh
