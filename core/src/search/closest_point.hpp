// SPDX-License-Identifier: MIT
/// @file
/// Distance from points to groups of triangles or line segments. The groups are the surfaces and curves of the input
/// near which the remeshed surfaces and curves must remain.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::search {

/// Returns the squared distance of p from the nearest point of the box; 0 inside.
inline double squared_distance_to(const Box3& b, const Vec3& p) {
  double s = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double d = std::max({b.min[i] - p[i], p[i] - b.max[i], 0.0});
    s += d * d;
  }
  return s;
}

inline Box3 box_about(const std::array<Vec3, 3>& corners, double reach) {
  Box3 box;
  for (const Vec3& p : corners) {
    box.add(p - Vec3{reach, reach, reach});
    box.add(p + Vec3{reach, reach, reach});
  }
  return box;
}

/// Returns the point of the triangle nearest to p (Ericson 2005, Real-Time Collision Detection, section 5.1.5),
/// accurate up to rounding of the coordinates even for needles. Two corners may be equal.
Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);
Vec3 closest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b);
/// Returns the nearest points of the segments ab and cd, which may be points (Ericson 2005, section 5.1.9).
std::array<Vec3, 2> closest_on_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// A triangle with precomputed values for finding its point nearest to other points. For a line segment the last two
/// corners are equal, for a point all three.
class PreparedTriangle {
 public:
  /// In a triangle narrower than `width_of_needle` times its length, the nearest point is accurate up to rounding of
  /// the coordinates, at four times the cost. In other triangles it is accurate to 1e-16 times the length, divided by
  /// the square of the ratio of width to length: 1e-6 of the length at worst.
  explicit PreparedTriangle(const std::array<Vec3, 3>& corners, double width_of_needle = 1e-5);
  const std::array<Vec3, 3>& corners() const { return corners_; }
  Vec3 closest_to(const Vec3& p) const;
  /// Returns the unit normal of the triangle; zero if it has no area.
  const Vec3& normal() const { return normal_; }

 private:
  Vec3 closest_on_sides(const Vec3& p) const;
  /// Finds the closest point of a triangle that is so narrow that barycentric coordinates would be inaccurate. It
  /// starts at the nearest side instead.
  Vec3 closest_in_needle(const Vec3& p) const;

  std::array<Vec3, 3> corners_;
  Vec3 ab_, ac_, normal_;
  double abab_, abac_, acac_, square_of_width_;
  bool has_area_, is_needle_;
};

struct ClosestPoint {
  double distance = std::numeric_limits<double>::infinity();
  Vec3 point;
  Index item = no_index;  ///< the caller's id of the triangle or line segment on which the point lies
};

/// Bounding-box trees, one for each group (the triangles of a patch, or the line segments of a class of curves). A line
/// segment is a triangle with its last two corners equal.
class ClosestPointTrees {
 public:
  struct Item {
    std::array<Vec3, 3> corners;
    Index group;
    Index id;
  };
  ClosestPointTrees() = default;
  /// O(n log n).
  ClosestPointTrees(std::vector<Item> items, std::size_t n_groups);

  /// Returns the nearest item of the group within `limit`; the distance is infinite if there is none. O(log n) for
  /// limits of the size of an item.
  ClosestPoint closest(const Vec3& p, Index group, double limit = std::numeric_limits<double>::infinity()) const;
  /// Calls visit(item) for the triangles or line segments of a group whose bounding boxes overlap `box`, and some more.
  template <class Visit>
  void for_each_in(const Box3& box, Index group, Visit visit) const {
    if (has_group(group)) visit_in(roots_[group], box, [&](Index row) { visit(items_[row]); });
  }
  /// Calls visit(row), with rows of items(), for the triangles or line segments of a group near the box.
  template <class Visit>
  void for_each_row_in(const Box3& box, Index group, Visit visit) const {
    if (has_group(group)) visit_in(roots_[group], box, visit);
  }
  bool has_group(Index group) const { return group < roots_.size() && roots_[group] != no_index; }
  const std::vector<Item>& items() const { return items_; }
  const PreparedTriangle& prepared(Index row) const { return prepared_[row]; }

 private:
  struct Node {
    Box3 box;
    Index first, last;  // items
    Index left = no_index, right = no_index;
  };
  Index build(Index first, Index last);
  template <class Visit>
  void visit_in(Index node, const Box3& box, const Visit& visit) const {
    const Node& n = nodes_[node];
    for (std::size_t i = 0; i < 3; ++i)
      if (n.box.min[i] > box.max[i] || n.box.max[i] < box.min[i]) return;
    if (n.left == no_index) {
      for (Index i = n.first; i < n.last; ++i) visit(i);
      return;
    }
    visit_in(n.left, box, visit);
    visit_in(n.right, box, visit);
  }

  std::vector<Item> items_;
  std::vector<PreparedTriangle> prepared_;
  std::vector<Node> nodes_;
  std::vector<Index> roots_;
};

}  // namespace geomesh::search
