// SPDX-License-Identifier: MIT
/// @file
/// Finds the cause of a bad element or a short edge: an input angle or thin gap, which only another input could widen.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geomesh/core/quality.hpp"
#include "geomesh/core/short_edges.hpp"
#include "quality/soup_star.hpp"
#include "quality/thin_gaps.hpp"

namespace geomesh {

/// Returns the feature edges that count as sides of facets. There are none if surfaces are kept exactly, because facets
/// that are merged are then coplanar.
InputCreases find_creases(const PiecewiseLinearComplex& plc, const QualityOptions& options);

class CauseFinder {
 public:
  /// The mesh, the options and the feature edges must outlive this object.
  CauseFinder(const ConstrainedTetrahedralization& mesh, const QualityOptions& options, const InputCreases& creases);
  /// Sets the cause of a bad element and its data. Angles at vertices are remembered for other elements there.
  void explain(WorstElement& w);
  /// Sets the cause of an edge that is shorter than `share` of its target size. `cells` are the cells around the edge.
  void explain(ShortEdge& e, std::span<const Index> cells, double share);

 private:
  const MeetingAngle& angle_at(VertexIndex v);
  bool explain_by_angle(WorstElement& w);  ///< returns whether an input angle makes the element bad
  void explain_by_gap(WorstElement& w) const;
  /// Returns whether a curve runs along the edge and would leave the tolerance if either end of the edge were removed.
  bool is_between_bends(const ShortEdge& e) const;
  bool is_needed_on_curve(VertexIndex v, double tolerance) const;
  bool are_ends_of_near_curves(const ShortEdge& e, bool have_common_neighbour) const;
  /// Returns the narrowest gap that the element spans and that the tolerance does not allow to close.
  Gap gap_of(Index tetrahedron) const {
    return gaps_.narrowest(tetrahedron, options_.tolerance_share > 0 ? 0 : 2 * options_.tolerance);
  }

  const ConstrainedTetrahedralization& mesh_;
  const QualityOptions& options_;
  SoupStars stars_;
  GapFinder gaps_;
  std::vector<MeetingAngle> angles_;  // least angle of input items at each vertex; negative if not computed yet
};

/// Returns the least dihedral angle (degrees) of the tetrahedron a b c d if it is below `bad_angle`, otherwise nothing.
std::optional<double> angle_if_bad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double bad_angle);

/// Returns those tetrahedra in `judged` that have a dihedral angle below the bad angle although no feature of the input
/// imposes it, the worst first. O(n), plus the cost of CauseFinder.
std::vector<Index> unforced_bad_elements(const ConstrainedTetrahedralization& mesh, const QualityOptions& options,
                                         const InputCreases& creases, std::span<const Index> judged);

}  // namespace geomesh
