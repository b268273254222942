// SPDX-License-Identifier: MIT
/// @file
/// Why an element is bad: an input angle or a thin gap that nothing but a change of the input could widen.
#pragma once

#include <vector>

#include "geomesh/core/quality.hpp"

namespace geomesh {

class CauseFinder {
 public:
  CauseFinder(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh, const QualityOptions& options);
  /// Sets the cause of an element and what goes with it. What is found at a vertex is kept for the next element there.
  void explain(WorstElement& w);

 private:
  struct SoupEdge {
    VertexIndex other;
    Index segment;  ///< where listed
    Index facet;    ///< of a face at the edge; no_index for one in the inside of a region
  };
  /// The least angle of the input at a vertex; at least the forcing angle where there is none that forces.
  struct ForcedAngle {
    double angle = -1;  ///< negative: not looked for yet
    Index facet_a = no_index, facet_b = no_index, segment_a = no_index, segment_b = no_index;
  };
  void collect_edges();
  const ForcedAngle& forced_angle_at(VertexIndex v);
  ForcedAngle least_angle_at(VertexIndex v) const;
  Index patch_of(Index face) const;
  bool explain_by_gap(WorstElement& w) const;
  double angle_between(VertexIndex v, Index face_a, Index face_b) const;
  double angle_of_edge(VertexIndex v, VertexIndex other, Index face) const;
  std::vector<Index> facets_at(VertexIndex v) const;

  const ConstrainedTetrahedralization& mesh_;
  const QualityOptions& options_;
  std::vector<std::vector<Index>> faces_at_;     // mesh faces by vertex
  std::vector<std::vector<SoupEdge>> edges_at_;  // edges where facets meet or end, and listed segments
  std::vector<ForcedAngle> forced_;              // by vertex
};

}  // namespace geomesh
