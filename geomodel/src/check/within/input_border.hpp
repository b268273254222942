// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds where a surface of the input ends, and where its ends may have been merged.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "check/exact/deviation.hpp"
#include "check/within/within_tolerance.hpp"

namespace geomesh::geomodel::checking {

/// Returns the surface's triangles after merging equal points; triangles that are degenerate then are omitted. O(n log
/// n).
std::vector<Triangle> welded(const TriangulatedSurface& surface);

/// The border edges of a surface, which have one triangle. Two of them that face each other may be merged in the mesh:
/// intersecting closes cracks as thin as rounding, and with a tolerance it merges features much closer than that.
class InputBorder {
 public:
  InputBorder(const TriangulatedSurface& surface, const Allowed& allowed);
  const std::vector<Corners>& edges() const { return edges_; }
  /// Returns whether the edge's midpoint lies on other triangles of the surface, up to rounding. Precondition: row <
  /// edges().size().
  bool is_crack(Index row) const { return cracks_[row]; }
  /// Returns whether place p of the edge has another part of the border within the allowed distance of surfaces, which
  /// is not reached along the border over twice that length. O(log n + edges within that length).
  bool faces_border(Index row, const Vec3& p) const;
  /// Returns whether place p of the edge has another piece of the surface within the allowed distance of surfaces.
  /// Pieces share no points; patches of one fault are joined in this way. O(log n + triangles within that length).
  bool faces_other_piece(Index row, const Vec3& p) const;

 private:
  std::vector<Corners> edges_;
  std::vector<std::array<VertexIndex, 2>> ends_;
  std::vector<bool> cracks_;
  std::map<VertexIndex, std::vector<Index>> at_;  ///< border edges at each end
  TriangleSet set_;                               ///< of edges_
  TriangleSet triangles_;                         ///< welded
  std::vector<VertexIndex> piece_of_triangle_;    ///< a vertex that represents the piece of each triangle
  std::vector<VertexIndex> piece_of_edge_;
  double length_ = 0;
};

}  // namespace geomesh::geomodel::checking
