// SPDX-License-Identifier: MIT
/// @file
/// Proof that a triangle lies within a given distance of a surface that continues under all of the triangle. The
/// triangle need not be cut up.
///
/// Consider the part of the surface over triangle F, as seen along the normal of F. Suppose that it is nowhere farther
/// from F's plane than the limit, nowhere steep, and without border or feature edge there. Then the set of points of F
/// that have the surface over them is closed. The set is also open in F, because around each point the surface
/// continues to all sides and remains within the limit. Unless it is empty, it is therefore all of F, which is
/// connected.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/closest_point.hpp"

namespace geomesh::search {

/// A triangle of a surface. Bit k is set if the surface does not continue smoothly across the edge from corner k.
struct SheetTriangle {
  const PreparedTriangle* triangle;
  std::uint8_t open_edges;
};

/// Returns for each item a mask in which bit k is set if the edge from corner k to the next is open. An edge is not
/// open if exactly two items of a group share it and are inclined to each other by less than 35 degrees. O(n log n).
std::vector<std::uint8_t> find_open_edges(std::span<const ClosestPointTrees::Item> items);

/// Relation of one triangle of a surface to triangle F, which is to be proven within a distance limit of the surface.
enum class Over : std::uint8_t {
  nothing,  ///< in projection along F's normal, the surface's triangle does not meet the triangle F to be proven
  part,     ///< the surface triangle's part over the triangle to be proven is near, not steep, without open edge
  border,   ///< the surface triangle's part over the triangle to be proven is too far or steep, or has an open edge
};

/// Proof that a triangle F is within a distance limit of a surface.
class SheetProof {
 public:
  /// Starts a proof that `triangle`, called F, is within the distance `limit` of a surface.
  SheetProof(const std::array<Vec3, 3>& triangle, double limit);
  /// Returns whether the triangle to be proven has an area, without which nothing can be proven.
  bool is_possible() const { return is_possible_; }
  Over judge(const SheetTriangle& t);
  /// Returns whether all of F (the triangle to be proven) is near the surface, if `judge` never returned `border`.
  bool is_proven() const { return has_seed_; }

 private:
  /// A point, given by its distances inwards from the three sides of triangle F and by its distance from F's plane.
  struct Point {
    std::array<double, 3> inside;
    double height;
  };
  static constexpr std::size_t most_corners = 8;  ///< capacity for the corners of a triangle that is cut at three sides
  /// Returns whether a triangle t of the surface is entirely beyond one side of triangle F. Otherwise `part` receives
  /// the distances of its corners from all sides of F.
  bool is_beside(const std::array<Vec3, 3>& t, std::array<Point, most_corners>& part) const;
  bool has_within(const Point& p, const Point& q) const;

  std::array<Vec3, 3> corners_, inward_;
  Vec3 normal_;
  double limit_ = 0, tiny_ = 0;
  bool is_possible_ = false, has_seed_ = false;
};

}  // namespace geomesh::search
