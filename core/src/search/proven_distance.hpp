// SPDX-License-Identifier: MIT
/// @file
/// Proof that a whole triangle, not only samples of it, lies within a distance of a set of triangles.
///
/// The distance to one triangle is a convex function, and the distance of a point to any set changes by no more than
/// the point moves. A triangle is therefore within the limit in each of these cases:
///   (a) its corners are within the limit of one triangle of the set;
///   (b) a ball around one of its points contains it, and that point is nearer than the limit by the radius of the
///     ball;
///   (c) two corners are near triangle X and the third is near triangle Y, which share an edge, and the chords between
///     the nearest points on X and on Y pass near that edge. Up to that distance, the edge divides the triangle of the
///     three nearest points into parts on X and on Y;
///   (d) the set is a smooth surface without a border over all of it (sheet_proof.hpp). If none of these applies, the
///   triangle is halved across its longest edge.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "search/sheet_proof.hpp"

namespace geomesh::search {

using Corners = std::array<Vec3, 3>;

/// Proves that triangles or line segments (triangles with their last two corners equal) lie within a limit of a set. An
/// object keeps its memory between calls and must be used by one thread only.
class DistanceProver {
 public:
  explicit DistanceProver(double limit) : limit_(limit) {}

  void set_limit(double limit) { limit_ = limit; }

  /// Returns whether all of `triangle` is proven to be within the limit of the set. Returns false if a point is not, or
  /// if the proof fails after halving down to a 16th of the limit or into a hundred pieces. O(pieces * set).
  bool is_within(const Corners& triangle, std::span<const SheetTriangle> set);
  bool is_within(const Corners& triangle, std::span<const Corners> set);
  /// Returns a triangle of the set if the last call of is_within() succeeded without halving because the set is one
  /// smooth surface over all of the triangle; otherwise no_index. The normals of the set's triangles there then all
  /// differ by less than 53 degrees from the triangle's normal, or all from its reversed normal.
  Index sheet_row() const { return sheet_row_; }

 private:
  struct Spot {
    double distance;
    Vec3 point;  ///< point on a triangle of the set, nearest to a corner of the piece to be proven
  };
  /// A triangle of the reference set near the piece to be proven, with its points nearest to the piece's corners.
  struct Candidate {
    Index row;
    std::array<Spot, 3> at;
  };
  /// Rows in candidates_ of the triangles near a piece; rows of those near its half that is being examined follow.
  struct Range {
    std::size_t first, last;
  };
  bool covers(const Corners& piece, Range range);
  bool has_corner_beyond(Range range) const;
  bool by_one_triangle(Range range) const;
  bool by_two_triangles(Range range);
  /// Returns a triangle of the set if it is one smooth surface over all of the piece to be proven, otherwise no_index.
  Index find_sheet(const Corners& piece, Range range) const;
  bool by_pair(const Candidate& x, const Candidate& y, std::size_t corner_at_y) const;
  Spot spot(const Vec3& p, Index row) const;

  double limit_;
  std::span<const SheetTriangle> set_;
  std::vector<Candidate> candidates_;
  std::vector<std::size_t> by_two_;  // rows in candidates_ of triangles within the limit of two corners of the piece
  std::vector<Spot> centres_;        // by candidate triangle, its point nearest to the middle of the longest edge
  std::size_t n_pieces_ = 0;
  Index sheet_row_ = no_index;
};

}  // namespace geomesh::search
