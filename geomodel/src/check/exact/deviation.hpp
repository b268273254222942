// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Checks whether triangles lie within a distance of a set of triangles: proven where possible, sampled elsewhere.
///
/// A triangle is within a distance t of a set if one of these conditions holds:
///   - its corners are within t of one triangle X of the set: the distance to a convex set is convex;
///   - two corners are within s of X, the third is within s of Y, and X and Y share an edge E. The chords from the
///     corners' nearest points on X to that on Y pass E at a distance of at most t - s. Then the triangle between these
///     nearest points can be mapped onto X and Y by moving the crossing points of the chords onto E;
///   - a corner is within s of the set and no corner is farther from that corner than t - s.
/// If none holds, the triangle is cut in two at its longest edge, until it is small compared with t.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "check/exact/box_tree.hpp"

namespace geomesh::geomodel::checking {

using Corners = std::array<Vec3, 3>;

/// Returns the point of the triangle (which may be degenerate) nearest to p. Ericson 2005, section 5.1.5.
Vec3 nearest_on_triangle(const Vec3& p, const Corners& t);

/// A set of triangles, prepared for measuring distances to it. Edges with equal coordinates are shared.
class TriangleSet {
 public:
  explicit TriangleSet(std::vector<Corners> triangles);

  struct Near {
    Index triangle;
    double distance;
    Vec3 point;  ///< of the triangle
  };
  /// Returns the triangles of the set within `reach` of p.
  std::vector<Near> near(const Vec3& p, double reach) const;
  double distance(const Vec3& p) const;
  std::optional<std::array<Vec3, 2>> shared_edge(Index a, Index b) const;
  bool empty() const { return triangles_.empty(); }

 private:
  std::vector<Corners> triangles_;
  /// Ids of the corners of the set's triangles; corners with equal coordinates have equal ids.
  std::vector<std::array<Index, 3>> corner_ids_;
  Box3 box_;
  BoxTree tree_;
};

/// Results of measuring triangles against a triangle set, accumulated over all measured triangles.
struct Deviation {
  double largest = 0;  ///< largest distance of a sampled point from the triangle set, among points within the tolerance
  /// Areas of the measured triangles: total, proven to be within the tolerance, and of pieces with all corners beyond
  /// the tolerance at places where this is no error.
  double area = 0, proven = 0, beyond = 0;
  double spacing = 0;  ///< longest edge of a piece of a triangle that was only sampled, not proven to be near
};

class DeviationChecker {
 public:
  /// `is_due` returns whether it is an error that a point of a measured triangle is farther from the set than the
  /// tolerance. Without this function it always is.
  DeviationChecker(const TriangleSet& set, double tolerance, std::function<bool(const Vec3&)> is_due = {});

  /// Measures how far one triangle is from the triangle set, and adds the results to `so_far`. Returns a point of the
  /// triangle that is farther than the tolerance, if this is an error there. The triangle is cut into at most
  /// `most_pieces` pieces. If nothing can be proven for a piece, only its corners are sampled.
  std::optional<Vec3> check(const Corners& triangle, Deviation& so_far) const;

 private:
  struct Spot {
    Vec3 p;
    std::vector<TriangleSet::Near> near;  ///< within the tolerance
  };
  struct Piece {
    std::array<Spot, 3> corners;
    int depth;
  };
  Spot look(const Vec3& p) const;
  bool is_fault(const Spot& spot) const { return spot.near.empty() && (!is_due_ || is_due_(spot.p)); }
  bool is_proven(const Piece& piece, double longest) const;
  bool is_proven_across_edge(const Spot& a, const Spot& b, const Spot& c) const;

  const TriangleSet& set_;
  double tolerance_;
  std::function<bool(const Vec3&)> is_due_;
};

}  // namespace geomesh::geomodel::checking
