// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the border of an input surface, and where the mesher may have merged parts of it.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "check/exact/deviation.hpp"
#include "check/within/within_tolerance.hpp"

namespace geomesh::geomodel::checking {

/// Returns the surface's triangles after merging equal points, without those that become degenerate. O(n log n).
std::vector<Triangle> welded(const TriangulatedSurface& surface);

/// The border edges of a surface, which have only one triangle. Two border edges that face each other may be merged in
/// the mesh: intersecting closes cracks as thin as rounding, and if the project has a tolerance, it merges features
/// that are much closer than that.
class InputBorder {
 public:
  InputBorder(const TriangulatedSurface& surface, const Allowed& allowed);
  const std::vector<Corners>& edges() const { return edges_; }
  /// Returns whether the border edge edges()[row] is a side of a crack: whether its midpoint lies on another triangle
  /// of the surface, up to rounding.
  bool is_crack(Index row) const { return cracks_[row]; }
  /// Returns whether another part of the surface's border is near the point p of a border edge: within the allowed
  /// distance of surfaces, but farther than twice that distance when following the border. O(log n + edges within that
  /// distance).
  bool faces_border(Index row, const Vec3& p) const;
  /// Returns whether another piece of the surface is near the point p of a border edge, within the allowed distance of
  /// surfaces. Pieces share no points; patches of one fault may be joined in this way. O(log n + triangles within that
  /// distance).
  bool faces_other_piece(Index row, const Vec3& p) const;

 private:
  std::vector<Corners> edges_;
  std::vector<std::array<VertexIndex, 2>> ends_;
  std::vector<bool> cracks_;
  std::map<VertexIndex, std::vector<Index>> at_;  ///< by vertex of the surface: the border edges that end at it
  TriangleSet set_;                               ///< of edges_
  TriangleSet triangles_;                         ///< welded
  std::vector<VertexIndex> piece_of_triangle_;    ///< by triangle: representative vertex of its connected piece
  std::vector<VertexIndex> piece_of_edge_;
  double length_ = 0;
};

}  // namespace geomesh::geomodel::checking
