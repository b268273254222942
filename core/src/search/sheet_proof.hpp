// SPDX-License-Identifier: MIT
/// @file
/// Proof that a triangle lies within a distance of a surface that goes on under all of it, without cutting it up.
///
/// Seen along the normal of triangle F, take what of the surface is over F. Let the surface be nowhere farther from F's
/// plane than the limit, nowhere steep, and without border or crease there. Then the set of F's points that have the
/// surface over them is closed. It is open in F too: about a point of the surface it goes on to all sides, to places
/// within the limit. So where it is not empty it is all of F, which is connected.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/closest_point.hpp"

namespace geomesh::search {

/// A triangle of a surface, and the edges over which the surface does not go on smoothly. Bit k is the edge from corner
/// k to the next.
struct SheetTriangle {
  const PreparedTriangle* triangle;
  std::uint8_t open_edges;
};

/// By item: bit k where its edge from corner k to the next is open. An edge is not open where exactly two of its group
/// share it and are inclined to each other by less than 35 degrees. O(n log n).
std::vector<std::uint8_t> find_open_edges(std::span<const ClosestPointTrees::Item> items);

/// What the proof asks of one triangle of the surface.
enum class Over : std::uint8_t {
  nothing,  ///< it is not over F
  part,     ///< what is over F is as it must be
  border,   ///< an open edge, too steep, or farther than the limit
};

/// Of one triangle F.
class SheetProof {
 public:
  /// `limit` from its plane.
  SheetProof(const std::array<Vec3, 3>& triangle, double limit);
  /// Whether the triangle has an area.
  bool is_possible() const { return is_possible_; }
  Over judge(const SheetTriangle& t);
  /// Where no triangle of the surface that may be over F was judged to be `border`: whether all of F is within the
  /// limit.
  bool is_proven() const { return has_seed_; }

 private:
  /// By its distances inwards from the three sides of F, and that from F's plane.
  struct Point {
    std::array<double, 3> inside;
    double height;
  };
  static constexpr std::size_t most_corners = 8;  ///< of what is left of a triangle between three sides
  /// Whether all of the triangle is beyond one side of F; else the distances of its corners from all sides come with
  /// it.
  bool is_beside(const std::array<Vec3, 3>& t, std::array<Point, most_corners>& part) const;
  bool has_within(const Point& p, const Point& q) const;

  std::array<Vec3, 3> corners_, inward_;
  Vec3 normal_;
  double limit_ = 0, tiny_ = 0;
  bool is_possible_ = false, has_seed_ = false;
};

}  // namespace geomesh::search
