// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Where a surface of the input ends, and where its ends may have been joined.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "check/exact/deviation.hpp"
#include "check/within/within_tolerance.hpp"

namespace geomesh::geomodel::checking {

/// The surface's triangles with equal points as one; triangles that are degenerate then are left out. O(n log n).
std::vector<Triangle> welded(const TriangulatedSurface& surface);

/// The edges of a surface that have one triangle. Two of them that face each other may become one in the mesh:
/// intersecting closes cracks as thin as rounding, and within a tolerance it brings together what is much nearer than
/// that.
class InputBorder {
 public:
  InputBorder(const TriangulatedSurface& surface, const Allowed& allowed);
  const std::vector<Corners>& edges() const { return edges_; }
  /// Whether the edge's middle is on other triangles of the surface, to rounding. Precondition: row < edges().size().
  bool is_crack(Index row) const { return cracks_[row]; }
  /// Whether the place p of the edge has another part of the border within what surfaces may be off: one that is not
  /// reached along the border by twice that length. O(log n + edges within that length).
  bool faces_border(Index row, const Vec3& p) const;
  /// Whether the place p of the edge has another piece of the surface within what surfaces may be off. Pieces share no
  /// points. Patches of one fault are joined so. O(log n + triangles within that length).
  bool faces_other_piece(Index row, const Vec3& p) const;

 private:
  std::vector<Corners> edges_;
  std::vector<std::array<VertexIndex, 2>> ends_;
  std::vector<bool> cracks_;
  std::map<VertexIndex, std::vector<Index>> at_;  ///< edges at each end
  TriangleSet set_;                               ///< of edges_
  TriangleSet triangles_;                         ///< welded
  std::vector<VertexIndex> piece_of_triangle_;    ///< a vertex that stands for it
  std::vector<VertexIndex> piece_of_edge_;
  double length_ = 0;
};

}  // namespace geomesh::geomodel::checking
