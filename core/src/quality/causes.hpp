// SPDX-License-Identifier: MIT
/// @file
/// Why an element is bad: an input angle or a thin gap that nothing but a change of the input could widen.
#pragma once

#include <vector>

#include "geomesh/core/quality.hpp"
#include "quality/soup_star.hpp"
#include "quality/thin_gaps.hpp"

namespace geomesh {

class CauseFinder {
 public:
  CauseFinder(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh, const QualityOptions& options);
  /// Sets the cause of an element and what goes with it. What is found at a vertex is kept for the next element there.
  void explain(WorstElement& w);

 private:
  const MeetingAngle& angle_at(VertexIndex v);
  bool explain_by_angle(WorstElement& w);  ///< whether that is its cause
  void explain_by_gap(WorstElement& w) const;

  const ConstrainedTetrahedralization& mesh_;
  const QualityOptions& options_;
  InputCreases creases_;
  SoupStars stars_;
  GapFinder gaps_;
  std::vector<MeetingAngle> angles_;  // by vertex; negative: not looked for yet
};

/// Rows of the elements below the bad angle that nothing forces, the worst first. O(n) but for what CauseFinder costs.
std::vector<Index> unforced_bad_elements(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh, const QualityOptions& options);

}  // namespace geomesh
