// SPDX-License-Identifier: MIT
/// @file
/// Proof that triangles, or line pieces, lie within a distance of many others. It takes whole surfaces, however large
/// the one and small the others.
///
/// The distance to one triangle is a convex function. So a convex piece whose corners are within the limit of one and
/// the same triangle is within it. Where there is no such triangle, the piece is cut by planes that stand on the sides
/// of the triangle nearest to its middle. What is between them lies over that triangle, what is not lies over others.
/// So along the sides where two triangles take turns the cut is made there, and not by pieces that are small against
/// the limit. Where no plane cuts, the piece is halved.
#pragma once

#include <vector>

#include "search/closest_point.hpp"
#include "search/proven_distance.hpp"
#include "search/recent_places.hpp"

namespace geomesh::search {

struct Cover {
  bool is_proven = false;  ///< all of it is within the limit; else one of its points, `place`, is not, or that was not
                           ///< decided about it
  double farthest = 0;     ///< largest distance of a point looked at: corners, middles of sides, centroid, corners and
                           ///< centroids of pieces
  Vec3 place;              ///< where that was; of what is not proven the point in question
};

/// For one thread. The rounding of cuts and distances (some ulps of the coordinates) is not accounted for: leave it a
/// share of the limit.
class CoverProver {
 public:
  /// `open_edges` of the items of the set (find_open_edges): with them what lies over a smooth surface needs no cuts.
  CoverProver(const ClosestPointTrees& set, double limit, std::span<const std::uint8_t> open_edges = {})
      : set_(set), limit_(limit), open_edges_(open_edges) {}

  /// For what is judged from now on.
  void set_limit(double limit) { limit_ = limit; }

  /// `item` (a line piece: its last two corners equal) against a group of the set. What is within the limit by next to
  /// nothing may be undecided, and is then not proven. O(log n + k log k) for k items of the group about the item, but
  /// for creases and folds within the limit.
  Cover judge(const Corners& item, Index group);

 private:
  using Polygon = std::vector<Vec3>;
  bool is_over_sheet(const Corners& item) const;
  bool covers_all(const Corners& item);
  /// Looks the set up anew for each half, until few of it are near. Undecided where that takes too many.
  bool covers_large(const Corners& item);
  /// `rows`: of near_.
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
