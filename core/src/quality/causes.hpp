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
  /// Sets the cause of an element and what goes with it.
  void explain(WorstElement& w) const;

 private:
  struct SoupEdge {
    VertexIndex other;
    Index segment;  ///< where listed
    Index facet;    ///< of a face at the edge; no_index for one in the inside of a region
  };
  void collect_edges();
  bool explain_by_angle_at(VertexIndex v, WorstElement& w) const;
  bool explain_by_gap(WorstElement& w) const;
  double angle_between(VertexIndex v, Index face_a, Index face_b) const;
  double angle_of_edge(VertexIndex v, VertexIndex other, Index face) const;
  std::vector<Index> facets_at(VertexIndex v) const;

  const ConstrainedTetrahedralization& mesh_;
  const QualityOptions& options_;
  std::vector<std::vector<Index>> faces_at_;     // mesh faces by vertex
  std::vector<std::vector<SoupEdge>> edges_at_;  // edges where facets meet or end, and listed segments
};

}  // namespace geomesh
