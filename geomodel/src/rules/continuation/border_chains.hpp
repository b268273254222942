// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Runs of a surface's border that stop short of walls.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "rules/framework/walls.hpp"
#include "rules/planar/borders.hpp"

namespace geomesh::geomodel {

enum class BorderState {
  open,         ///< no wall is near
  before_wall,  ///< the surface stops short of a wall
  met_wall,     ///< a wall cuts the edge off from the surface, or the surface ends on it
};
using MapEdge = std::pair<VertexIndex, VertexIndex>;
/// By border edge, in the direction of its triangle over the first of equal points.
using BorderStates = std::map<MapEdge, BorderState>;
/// What is near is as chains_before_walls has it. O(edges) searches.
BorderStates border_states(const TriangulatedSurface& surface, Index row, const Walls& walls, const Box3& box,
                           double within);

/// A run of border edges with walls before them.
struct BorderChain {
  std::vector<VertexIndex> vertices;  ///< rows of the surface; edge k joins vertex k and the next
  std::vector<Index> triangles;       ///< per edge: the triangle of the surface there
  std::vector<std::uint8_t> goes_on;  ///< per edge: 0 where the surface has met its wall already
  std::vector<std::uint8_t> cut_off;  ///< per edge, by bits: 1 where a wall cuts its first vertex off, 2 its second
  bool closed = false;                ///< the last vertex is joined to the first
  std::vector<Index> walls;  ///< surfaces before its edges in the model, ascending; Walls::side_of_volume among them
  double farthest = 0;       ///< distance to the farthest wall that its edges meet first, m
  double length = 0;         ///< m
  Vec3 place;                ///< on the edge whose wall is farthest
  std::size_t n_edges() const { return triangles.size(); }
};

/// Chains of the border whose edges have a wall within `within`, straight ahead or half to the left or right in the
/// surface's own plane. An edge without a wall between two that have one belongs to the chain as far as no more than
/// `within` of the border is without. Edges outside of the model belong to a chain that passes them, and so
/// do edges that a wall cuts off from their own triangle. A chain has an edge in the model that goes on. Edges of
/// triangles that are `done` belong to none; rows beyond these are not. O(edges) searches.
std::vector<BorderChain> chains_before_walls(const TriangulatedSurface& surface, Index row, const Walls& walls,
                                             const Box3& box, double within, const std::vector<bool>& done = {});

}  // namespace geomesh::geomodel
