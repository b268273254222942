// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The fault blocks of a model: the parts into which faults, bodies and the sides of the model divide its volume.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "geomesh/core/run_context.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "rules/framework/tetrahedron_search.hpp"

namespace geomesh::geomodel {

/// Faults, bodies and the horizons at which faults end are intersected with the sides of the model and tetrahedralized;
/// a block is a component of that mesh, so every place lies in exactly one block, except on the walls themselves. A
/// fault that ends inside the model leaves one block around its tip.
///
/// Invariants: the tetrahedra fill the model's volume and do not overlap (tetrahedralize validates its result); walls
/// consist of faces of the mesh.
class BlockFramework {
 public:
  /// Uses the built faults and bodies, cut as end_faults does. Requires ContinuationRules::sides. Throws as arrange and
  /// tetrahedralize do.
  BlockFramework(const BuiltSurfaces& built, const ModelRules& rules);

  Index n_blocks() const { return static_cast<Index>(has_tip_.size()); }
  /// Returns the block that contains p, or no_index outside the model. On a wall, returns the block of a tetrahedron
  /// that touches it. `last` speeds up consecutive queries: it holds the tetrahedron of the previous one, no_index at
  /// first. Cost: that of TetrahedronSearch::find.
  Index block_at(const Vec3& p, Index& last) const;
  Index block_at(const Vec3& p) const;
  /// Of a triangle that crosses no wall, by the first of some of its places that lies in the model.
  Index block_of(const std::array<Vec3, 3>& triangle, Index& last) const;
  /// Returns whether some of the triangle lies in the block. This is decided by clipping in doubles, so the result is
  /// not defined for a triangle that reaches in by no more than rounding. O(log n + k) for the k tetrahedra near the
  /// triangle.
  bool overlaps(Index block, const std::array<Vec3, 3>& triangle) const;
  /// The area of the triangle in each block that it reaches. Clipped in doubles, like overlaps.
  std::map<Index, double> areas(const std::array<Vec3, 3>& triangle) const;
  /// The blocks through which the segment passes. Clipped in doubles, like overlaps.
  std::set<Index> blocks_on(const Vec3& a, const Vec3& b) const;
  /// Returns whether a wall ends inside the block, so that both of its sides belong to it.
  bool has_tip(Index block) const { return has_tip_[block]; }
  /// Returns whether a wall ends inside the block that contains p; false outside the model.
  bool has_tip_at(const Vec3& p) const {
    const Index block = block_at(p);
    return block != no_index && has_tip(block);
  }
  /// 1 where the block lies on the upper side of a wall, -1 on the lower one, 0 where it does not touch the wall.
  int side_of(Index block, Index wall) const;
  /// Per block, on which side of a wall it lies, like side_of; blocks that do not touch the wall are on the side of
  /// those that they hang together with round other walls. 0 where the wall does not separate its two sides.
  std::vector<int> sides_of(Index wall) const;
  const Vec3& place_in(Index block) const { return place_[block]; }  ///< amid its largest tetrahedron
  const Box3& bounds(Index block) const { return bounds_[block]; }

 private:
  /// Calls visit(block, polygon) with what of the triangle lies in each tetrahedron near it.
  template <class F>
  void for_each_piece(const std::array<Vec3, 3>& triangle, F&& visit) const;

  std::vector<Index> block_;  ///< per tetrahedron
  std::vector<bool> has_tip_;
  /// By block and wall: area of the wall in the map that the block lies above, less the area that it lies below.
  std::map<std::pair<Index, Index>, double> side_;
  /// Blocks with a face between them, the lower one first, and the rows of the walls that lie on that face.
  std::set<std::tuple<Index, Index, std::vector<Index>>> contacts_;
  std::vector<Box3> bounds_;
  std::vector<Vec3> place_;
  std::unique_ptr<TetrahedronSearch> search_;
};

}  // namespace geomesh::geomodel
