// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A bounding volume tree over boxes. Its structure and the order of its results depend on the boxes alone.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel::checking {

inline Box3 box_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  Box3 box;
  box.add(a);
  box.add(b);
  box.add(c);
  return box;
}
inline Box3 inflated(Box3 box, double by) {
  box.min = box.min - Vec3{by, by, by};
  box.max = box.max + Vec3{by, by, by};
  return box;
}
inline bool overlap(const Box3& a, const Box3& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
         b.min.z <= a.max.z;
}

/// Bounding volume tree that is split at the median along the longest axis. Building takes O(n log n), a query O(log n
/// + results) on well-spread boxes.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box3> boxes) : boxes_(std::move(boxes)), items_(boxes_.size()) {
    std::iota(items_.begin(), items_.end(), Index{0});
    if (!items_.empty()) build(0, static_cast<Index>(items_.size()));
  }

  /// Calls visit(item) for every item of the tree whose box meets `box`, in an order that depends only on the tree.
  template <class Visit>
  void query(const Box3& box, Visit&& visit) const {
    if (nodes_.empty()) return;
    std::vector<Index> stack{0};
    while (!stack.empty()) {
      const Node& node = nodes_[stack.back()];
      const Index left = stack.back() + 1;
      stack.pop_back();
      if (!overlap(node.box, box)) continue;
      if (node.right == 0) {
        for (Index i = node.begin; i < node.end; ++i)
          if (overlap(boxes_[items_[i]], box)) visit(items_[i]);
      } else {
        stack.push_back(node.right);
        stack.push_back(left);
      }
    }
  }

 private:
  struct Node {
    Box3 box;
    Index begin, end;
    Index right = 0;  ///< index of the right child, 0 for a leaf; the left child directly follows its parent
  };

  Index build(Index begin, Index end) {
    constexpr Index leaf_size = 4;
    const auto id = static_cast<Index>(nodes_.size());
    Box3 box;
    for (Index i = begin; i < end; ++i) {
      box.add(boxes_[items_[i]].min);
      box.add(boxes_[items_[i]].max);
    }
    nodes_.push_back({box, begin, end});
    if (end - begin <= leaf_size) return id;
    const Vec3 size = box.max - box.min;
    const std::size_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const Index middle = begin + (end - begin) / 2;
    const auto twice_centre = [&](Index item) { return boxes_[item].min[axis] + boxes_[item].max[axis]; };
    std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end, [&](Index a, Index b) {
      return twice_centre(a) != twice_centre(b) ? twice_centre(a) < twice_centre(b) : a < b;
    });
    build(begin, middle);
    const Index right = build(middle, end);
    nodes_[id].right = right;
    return id;
  }

  std::vector<Box3> boxes_;
  std::vector<Index> items_;
  std::vector<Node> nodes_;
};

}  // namespace geomesh::geomodel::checking
