// SPDX-License-Identifier: MIT
/// @file
/// Proof that triangles or line segments lie within a given distance of a set of many others. It works for whole
/// surfaces, even if one surface has large triangles and the other small ones.
///
/// The distance to one triangle is a convex function, so a convex piece whose corners are within the limit of one
/// triangle is within the limit as a whole. If there is no such triangle, the piece is cut by planes perpendicular to
/// the triangle nearest to its centre, through the sides of that triangle. The part between the planes lies over that
/// triangle, the rest over others. The piece is thereby cut exactly at sides between two triangles, and need not become
/// small relative to the limit. If no plane cuts the piece, it is halved.
#pragma once

#include <vector>

#include "search/closest_point.hpp"
#include "search/proven_distance.hpp"
#include "search/recent_places.hpp"

namespace geomesh::search {

struct Cover {
  /// True if the whole item (triangle or line segment) is within the distance limit; otherwise `place` may not be.
  bool is_proven = false;
  /// Largest distance from the reference set of the points examined on the item: corners, midpoints of sides, centroids
  /// of pieces.
  double farthest = 0;
  Vec3 place;  ///< examined point at the largest distance; if nothing is proven, where the proof failed
};

/// Proves that triangles or line segments lie within a distance limit of a set of others; for one thread only. Callers
/// must reserve a share of the limit for rounding errors of cuts and distances, some ulps of the coordinates.
class CoverProver {
 public:
  /// `open_edges` (from find_open_edges) lets triangles over smooth parts of the set be proven without being cut.
  CoverProver(const ClosestPointTrees& set, double limit, std::span<const std::uint8_t> open_edges = {})
      : set_(set), limit_(limit), open_edges_(open_edges) {}

  void set_limit(double limit) { limit_ = limit; }

  /// Tries to prove that `item` lies within the limit of a group of the set. A line segment has its last two corners
  /// equal. A piece whose distance nearly equals the limit may remain undecided, and is then not proven. O(log n + k
  /// log k) for k items of the group near the item, apart from feature edges and folds within the limit.
  Cover judge(const Corners& item, Index group);

 private:
  using Polygon = std::vector<Vec3>;
  bool is_over_sheet(const Corners& item) const;
  bool covers_all(const Corners& item);
  /// Halves a large triangle and searches the set again for each half, until few of the set's triangles are near it.
  /// The proof fails if this takes too many halves.
  bool covers_large(const Corners& item);
  /// Tries to prove that a convex piece lies within the distance limit of a set of triangles, given as rows of near_.
  bool covers(const Polygon& piece, std::vector<Index> rows);
  bool covers_by_cuts(const Polygon& piece, const std::vector<Index>& rows);
  bool covers_halves(const Polygon& piece, const std::vector<Index>& rows);
  void look_at(const Vec3& p, double distance);
  bool fails_at(const Vec3& p, double distance);

  const ClosestPointTrees& set_;
  double limit_;
  std::span<const std::uint8_t> open_edges_;
  Index group_ = no_index;
  Cover cover_;
  std::vector<const PreparedTriangle*> near_;
  RecentPlaces distances_;  // to the group
  std::size_t pieces_left_ = 0, halves_left_ = 0;
};

}  // namespace geomesh::search
