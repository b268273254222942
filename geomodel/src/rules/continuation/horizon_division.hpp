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

/// The triangles of a horizon with their fault blocks and neighbours. A triangle belongs to no block if a bounding
/// surface cuts one of its edges. The horizon and the framework must outlive this object.
class HorizonDivision {
 public:
  /// `cutters` are the faults and bodies that bound blocks; `states`: which border edges have met a bounding surface.
  HorizonDivision(const TriangulatedSurface& horizon, Index row, const BlockFramework& framework, const Walls& cutters,
                  const BorderStates& states);

  const std::vector<Triangle>& triangles() const { return triangles_; }  ///< of merged_triangles
  /// Returns whether a bounding surface cuts an edge of the triangle.
  bool crosses_wall(Index t) const { return crosses_[t]; }
  /// Returns how a border edge of the horizon lies relative to the bounding surfaces; nothing for an inner edge.
  std::optional<BorderState> border_state(VertexIndex a, VertexIndex b) const;
  /// Returns the triangles from which the horizon is continued in a block: those in the block, those connected with
  /// them outside the model, and those next to either that cross a wall (bounding surface). Triangles that cross one,
  /// reach into the block and are connected with these are included, since in a narrow block all triangles cross walls.
  std::vector<Index> sheet_of(Index block) const;

 private:
  template <class F>
  void for_each_edge_of(Index t, F&& visit) const {
    for (std::size_t i = 0; i < 3; ++i) visit(triangles_[t][i], triangles_[t][(i + 1) % 3]);
  }
  bool has_area(Index t) const { return triangles_[t][0] != triangles_[t][1]; }
  Index block_of(Index t, Index& last) const;
  std::array<Vec3, 3> corners(Index t) const {
    const auto& [a, b, c] = triangles_[t];
    return {horizon_.points[a], horizon_.points[b], horizon_.points[c]};
  }

  const TriangulatedSurface& horizon_;
  const BlockFramework& framework_;
  std::map<MapEdge, BorderState> states_;
  std::vector<Triangle> triangles_;
  std::vector<std::pair<MapEdge, Index>> at_edge_;  ///< edges of the horizon, each with one triangle at it, ascending
  std::vector<bool> crosses_;
  std::vector<Index> block_;
};

}  // namespace geomesh::geomodel
