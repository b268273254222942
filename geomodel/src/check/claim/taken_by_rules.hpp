// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which points of an input surface the rules of the model may have taken away, judged point by point from the input
/// surfaces: heights on the vertical, distances, the outside of the volume. No report of the run is asked.
#pragma once

#include <cstdint>
#include <vector>

#include "check/claim/claim.hpp"
#include "check/exact/box_tree.hpp"

namespace geomesh::geomodel::checking {

class TakenByRules {
 public:
  /// `room`: within this of the limit of a rule a point may have been taken.
  TakenByRules(const Claim& claim, double room);

  /// Whether p, a point of triangle `triangle` of the surface, may be away: outside the volume, or by a rule. Pieces go
  /// as wholes, and may reach over another block: heights across faults count.
  bool may_be_away(Index surface, Index triangle, const Vec3& p) const;
  /// The same without regard to throw, by which any part of a horizon may go.
  bool may_be_away_but_for_throw(Index surface, Index triangle, const Vec3& p) const;
  /// Whether p, a point of the surface, is beyond one of the surfaces that cut it by rule, so that it tells of its
  /// piece. A horizon is not beyond one that lies across a fault on the vertical: that is of another block.
  bool is_beyond_cutters(Index surface, const Vec3& p) const;
  /// Whether p is outside the volume (which need not be a box) or within the room of its sides.
  bool is_outside(const Vec3& p) const;

 private:
  enum class Heights : std::uint8_t { of_all_blocks, of_one_block };
  bool is_beyond_cutters(Index surface, const Vec3& p, Heights heights) const;
  bool is_beyond(Index other, const Vec3& p, bool above, Heights heights) const;
  bool is_fault_between(const Vec3& p, double z) const;
  bool is_outside_domain(Index surface, Index triangle, const Vec3& p) const;
  /// By the plane of the triangle that is nearest to p, its normal turned to the upper side of the whole fault.
  bool is_above_fault(Index fault, const Vec3& p) const;
  bool is_near_another(Index surface, const Vec3& p, double distance, bool faults_alone) const;

  const Claim& claim_;
  double room_;
  std::vector<BoxTree> trees_;  ///< over the triangles of each surface
  std::vector<Vec3> upward_;    ///< per surface: sum of its normals, each turned upwards
};

}  // namespace geomesh::geomodel::checking
