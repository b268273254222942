// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Decides which points of an input surface the rules of the model may have removed, from the input surfaces alone: by
/// heights along vertical lines, by distances, and by the extent of the volume. Reports of the run are not used.
#pragma once

#include <cstdint>
#include <vector>

#include "check/exact/box_tree.hpp"
#include "check/specification/specification.hpp"

namespace geomesh::geomodel::checking {

class TakenByRules {
 public:
  /// `room` is the distance from parts of surfaces that rules remove within which other points may also be missing in
  /// the mesh.
  TakenByRules(const Specification& specification, double room);

  /// Returns whether the point p of the given triangle of the surface may be missing in the mesh, because it is outside
  /// the volume or because a rule removed it. Rules remove pieces as a whole, and pieces may extend into another fault
  /// block, so heights of surfaces across faults count, too.
  bool may_be_away(Index surface, Index triangle, const Vec3& p) const;
  /// Returns whether the point p of the surface may be missing in the mesh for another reason than throw. Throw is
  /// ignored, because it allows any part of a horizon to be removed.
  bool may_be_away_but_for_throw(Index surface, Index triangle, const Vec3& p) const;
  /// Returns whether the point p of the surface is beyond one of the surfaces that cut it by rule, so that the piece
  /// around p may be removed. A cutting surface that lies across a fault from p along the vertical line does not count,
  /// because it belongs to another block.
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
  /// Returns whether p is above the fault, according to the plane of the nearest triangle, with normals turned to the
  /// upper side of the whole fault.
  bool is_above_fault(Index fault, const Vec3& p) const;
  bool is_near_another(Index surface, const Vec3& p, double distance, bool faults_alone) const;

  const Specification& specification_;
  double room_;
  std::vector<BoxTree> trees_;
  std::vector<Vec3> upward_;  ///< sum of the normals of each surface, each turned upwards
};

}  // namespace geomesh::geomodel::checking
