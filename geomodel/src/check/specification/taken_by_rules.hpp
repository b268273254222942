// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Decides which points of an input surface the rules of the model may have removed, point by point from the input
/// surfaces: heights on the vertical, distances, the outside of the volume. Reports of the run are not used.
#pragma once

#include <cstdint>
#include <vector>

#include "check/exact/box_tree.hpp"
#include "check/specification/specification.hpp"

namespace geomesh::geomodel::checking {

class TakenByRules {
 public:
  /// `room`: points closer than this to the limit of a rule may have been removed.
  TakenByRules(const Specification& specification, double room);

  /// Returns whether p, a point of triangle `triangle` of the surface, may be absent: outside the volume, or because of
  /// a rule. Pieces are removed as a whole, and may extend over another block, so heights across faults count.
  bool may_be_away(Index surface, Index triangle, const Vec3& p) const;
  /// Like the function above, but without regard to throw, because of which any part of a horizon may be removed.
  bool may_be_away_but_for_throw(Index surface, Index triangle, const Vec3& p) const;
  /// Returns whether p, a point of the surface, is beyond one of the surfaces that cut it by rule, so that its piece
  /// may be removed. A horizon is not beyond one that lies across a fault on the vertical, since that belongs to
  /// another block.
  bool is_beyond_cutters(Index surface, const Vec3& p) const;
  /// Returns whether p is outside the volume (which need not be a box) or closer than the allowed distance to its
  /// sides.
  bool is_outside(const Vec3& p) const;

 private:
  enum class Heights : std::uint8_t { of_all_blocks, of_one_block };
  bool is_beyond_cutters(Index surface, const Vec3& p, Heights heights) const;
  bool is_beyond(Index other, const Vec3& p, bool above, Heights heights) const;
  bool is_fault_between(const Vec3& p, double z) const;
  bool is_outside_domain(Index surface, Index triangle, const Vec3& p) const;
  /// Decides by the plane of the triangle nearest to p, with its normal turned to the upper side of the whole fault.
  bool is_above_fault(Index fault, const Vec3& p) const;
  bool is_near_another(Index surface, const Vec3& p, double distance, bool faults_alone) const;

  const Specification& specification_;
  double room_;
  std::vector<BoxTree> trees_;  ///< tree over the triangles of each surface
  std::vector<Vec3> upward_;    ///< for each surface: the sum of its normals, each turned upwards
};

}  // namespace geomesh::geomodel::checking
