// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds chains of border edges at which a surface stops short of bounding surfaces.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "rules/framework/walls.hpp"
#include "rules/planar/borders.hpp"

namespace geomesh::geomodel {

enum class BorderState {
  open,         ///< no bounding surface is near the border edge
  before_wall,  ///< the surface stops short of a bounding surface
  met_wall,     ///< a bounding surface separates the edge from the surface, or the surface ends on it
};
using MapEdge = std::pair<VertexIndex, VertexIndex>;
/// State of each border edge. The key is its two ends, in the direction in which its triangle traverses it; points with
/// equal coordinates count as the first of them.
using BorderStates = std::map<MapEdge, BorderState>;
/// Returns whether each border edge has met a bounding surface, stops short of one within `within` (m), or is open.
/// O(edges) searches.
BorderStates border_states(const TriangulatedSurface& surface, Index row, const Walls& walls, const Box3& box,
                           double within);

/// Returns for each bounding surface the length in m of border edges that end on it or have it first in front of them.
std::map<Index, double> lengths_before(const TriangulatedSurface& surface, Index row, const Walls& walls,
                                       const Box3& box, double within);

/// A chain of border edges that have bounding surfaces in front of them.
struct BorderChain {
  std::vector<VertexIndex> vertices;  ///< the surface's vertices along the chain; edge k connects vertex k and the next
  std::vector<Index> triangles;       ///< for each edge of the chain: the surface's triangle at it
  std::vector<std::uint8_t> goes_on;  ///< per edge of the chain: 0 if the surface reaches a bounding surface before it
  /// For each edge of the chain, the sum of 1 if a bounding surface separates its first vertex from the surface, and 2
  /// if one separates its second vertex.
  std::vector<std::uint8_t> cut_off;
  bool closed = false;  ///< whether the chain's last vertex is connected to its first
  /// Indices of bounding surfaces in front of chain edges in the model, ascending; may include Walls::side_of_volume.
  std::vector<Index> walls;
  double farthest = 0;  ///< largest distance in m from an edge to the bounding surface in front of it
  double length = 0;    ///< m
  Vec3 place;           ///< a place on that edge of the chain that is farthest from its bounding surface
  std::size_t n_edges() const { return triangles.size(); }
};

/// Returns chains of border edges that have a wall (bounding surface) closer than `within`, straight ahead or at 45
/// degrees to the left or right in the surface's own plane. Edges without a wall between edges that have one belong to
/// the chain if their total length is at most `within`. Edges outside the model, and edges that a wall separates from
/// their own triangle, belong to a chain that passes them. Each chain has an edge in the model that is to be continued.
/// Edges of triangles that are `done` belong to no chain; triangles beyond the end of `done` count as not done.
/// O(edges) searches.
std::vector<BorderChain> chains_before_walls(const TriangulatedSurface& surface, Index row, const Walls& walls,
                                             const Box3& box, double within, const std::vector<bool>& done = {});

}  // namespace geomesh::geomodel
