// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Computes the fault blocks of a model, into which faults, bodies and the sides of the model divide its volume.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "geomesh/core/run_context.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "rules/framework/tetrahedron_search.hpp"

namespace geomesh::geomodel {

/// The fault blocks of a model. Faults, bodies and the horizons at which faults end are intersected with the sides of
/// the model and tetrahedralized. A block is a connected component of that mesh, so every point lies in exactly one
/// block, except on the bounding surfaces themselves. Both sides of a fault that ends inside the model belong to the
/// block around its tip. Invariants: the tetrahedra fill the model's volume and do not overlap (tetrahedralize()
/// validates its result); bounding surfaces consist of faces of the mesh.
class BlockFramework {
 public:
  /// Computes the blocks from the built faults and bodies, after end_faults() has cut them. Requires
  /// ContinuationRules::sides. Throws as arrange() and tetrahedralize() do.
  BlockFramework(const BuiltSurfaces& built, const ModelRules& rules);

  Index n_blocks() const { return static_cast<Index>(has_tip_.size()); }
  /// Returns the block that contains p, or no_index outside the model. On a bounding surface, returns the block of a
  /// tetrahedron that touches p. `last` speeds up consecutive queries: it holds the tetrahedron that the previous query
  /// found, initially no_index. Cost: that of TetrahedronSearch::find().
  Index block_at(const Vec3& p, Index& last) const;
  Index block_at(const Vec3& p) const;
  /// Returns whether some part of the triangle lies in the block. Clipping in doubles decides, so the result is
  /// undefined for a triangle that reaches in only by rounding. O(log n + k) for the k tetrahedra near the triangle.
  bool overlaps(Index block, const std::array<Vec3, 3>& triangle) const;
  /// Returns whether a bounding surface ends inside the block, so that both of its sides belong to it.
  bool has_tip(Index block) const { return has_tip_[block]; }
  /// Returns whether a bounding surface ends inside the block that contains p; false outside the model.
  bool has_tip_at(const Vec3& p) const {
    const Index block = block_at(p);
    return block != no_index && has_tip(block);
  }
  /// Returns 1 if the block lies on the upper side of a horizon at which faults end (BuiltRows::truncations), -1 on the
  /// lower one, 0 if it does not touch the horizon.
  int side_of_unconformity(Index block, Index horizon) const;
  const Box3& bounds(Index block) const { return bounds_[block]; }

 private:
  std::vector<Index> block_;  ///< per tetrahedron
  std::vector<bool> has_tip_;
  std::map<std::pair<Index, Index>, double>
      side_;  ///< for each block and unconformity: area in the map above the unconformity minus area below it
  std::vector<Box3> bounds_;
  std::unique_ptr<TetrahedronSearch> search_;
};

}  // namespace geomesh::geomodel
