// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines which triangles of a horizon lie in which fault block.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "rules/continuation/border_chains.hpp"
#include "rules/framework/block_framework.hpp"
#include "rules/framework/walls.hpp"

namespace geomesh::geomodel {

/// What is known of the triangles of a horizon with throw, which may overshoot walls.
struct HeldTriangles {
  std::vector<Index> block{};     ///< per triangle, BuiltRows::of_every_block where it is of several; empty: nothing
  std::vector<Index> of_block{};  ///< per block of the framework: the number that it has there
};

/// The triangles of a horizon with their blocks and neighbours. A triangle with an edge that a wall cuts belongs to no
/// block. References the horizon and the framework, which must outlive it.
class HorizonDivision {
 public:
  /// `cutters`: faults and bodies. `states`: of the horizon's border. Only what is held by a
  /// block, or by every one, counts there.
  HorizonDivision(const TriangulatedSurface& horizon, Index row, const BlockFramework& framework, const Walls& cutters,
                  const BorderStates& states, const HeldTriangles& held = {});

  const std::vector<Triangle>& triangles() const { return triangles_; }  ///< of merged_triangles
  /// Returns whether a wall cuts an edge of the triangle.
  bool crosses_wall(Index t) const { return crosses_[t]; }
  /// Returns the state of an edge at which the horizon ends; nothing if the horizon continues there.
  std::optional<BorderState> border_state(VertexIndex a, VertexIndex b) const;
  /// Whether the block, or every one, holds the triangle.
  bool may_be_in(Index t, Index block) const {
    return held_.block.empty() || held_.block[t] == BuiltRows::of_every_block ||
           held_.block[t] == held_.of_block[block];
  }
  /// Returns the triangles of the block; those connected with them outside the model; those next to these that cross a
  /// wall; and those connected with these that cross a wall and reach into the block, since in a narrow block all
  /// triangles do.
  std::vector<Index> sheet_of(Index block) const;

 private:
  template <class F>
  void for_each_edge_of(Index t, F&& visit) const {
    for (std::size_t i = 0; i < 3; ++i) visit(triangles_[t][i], triangles_[t][(i + 1) % 3]);
  }
  bool has_area(Index t) const { return triangles_[t][0] != triangles_[t][1]; }  ///< whether its corners are distinct
  std::array<Vec3, 3> corners(Index t) const {
    const auto& [a, b, c] = triangles_[t];
    return {horizon_.points[a], horizon_.points[b], horizon_.points[c]};
  }

  const TriangulatedSurface& horizon_;
  const BlockFramework& framework_;
  HeldTriangles held_;
  std::map<MapEdge, BorderState> states_;
  std::vector<Triangle> triangles_;
  std::vector<std::pair<MapEdge, Index>> at_edge_;  ///< edges with their triangles, in ascending order
  std::vector<bool> crosses_;
  std::vector<Index> block_;
};

}  // namespace geomesh::geomodel
