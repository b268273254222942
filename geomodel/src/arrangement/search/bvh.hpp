// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Broad phase: a bounding volume hierarchy over Morton-sorted boxes (Lauterbach et al. 2009, "Fast BVH construction on
/// GPUs", without pointers: a complete binary tree over leaves of a few boxes).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel::arrangement {

/// A closed box in floats relative to the tree's origin. Conversion from doubles is monotone, so boxes that meet in
/// doubles meet in floats, too.
struct FloatBox {
  std::array<float, 3> lo, hi;
  bool meets(const FloatBox& o) const {
    return lo[0] <= o.hi[0] && o.lo[0] <= hi[0] && lo[1] <= o.hi[1] && o.lo[1] <= hi[1] && lo[2] <= o.hi[2] &&
           o.lo[2] <= hi[2];
  }
  void add(const FloatBox& o) {
    for (std::size_t i = 0; i < 3; ++i) {
      lo[i] = o.lo[i] < lo[i] ? o.lo[i] : lo[i];
      hi[i] = o.hi[i] > hi[i] ? o.hi[i] : hi[i];
    }
  }
};

class BoxTree {
 public:
  static constexpr std::size_t leaf_size = 4;

  /// Builds the tree in n log n time (sorting), in parallel. Boxes must not be empty. The tree is the same whatever the
  /// number of threads. `groups`, if not empty, has a group or no_index for each box: boxes of one group are kept
  /// together, and pairs within it are not visited.
  explicit BoxTree(const std::vector<Box3>& boxes, std::span<const Index> groups = {});

  std::size_t n_leaves() const { return n_leaves_; }

  /// Calls visit(i, j) once for each unordered pair i != j of boxes that meet, one of them in the given leaf and the
  /// other in that leaf or a later one. Leaves can be visited in parallel.
  template <typename Visit>
  void pairs_of_leaf(std::size_t leaf, Visit&& visit) const {
    const std::size_t begin = leaf * leaf_size, end = std::min(begin + leaf_size, order_.size());
    const auto visit_pair = [&](std::size_t a, std::size_t b) {
      if (boxes_[a].meets(boxes_[b]) && (groups_.empty() || groups_[a] == no_index || groups_[a] != groups_[b]))
        visit(order_[a], order_[b]);
    };
    const Index group = node_groups_.empty() ? no_index : node_groups_[n_slots_ + leaf];
    for (std::size_t a = begin; a < end && group == no_index; ++a)
      for (std::size_t b = a + 1; b < end; ++b) visit_pair(a, b);
    const FloatBox query = nodes_[n_slots_ + leaf];
    descend(query, leaf + 1, group, [&](std::size_t other) {
      const std::size_t stop = std::min((other + 1) * leaf_size, order_.size());
      for (std::size_t b = other * leaf_size; b < stop; ++b)
        if (boxes_[b].meets(query))
          for (std::size_t a = begin; a < end; ++a) visit_pair(a, b);
    });
  }

  /// Calls visit(i) for each box that meets `box`.
  template <typename Visit>
  void boxes_meeting(const Box3& box, Visit&& visit) const {
    if (order_.empty()) return;
    const FloatBox query = relative(box);
    descend(query, 0, no_index, [&](std::size_t leaf) {
      const std::size_t stop = std::min((leaf + 1) * leaf_size, order_.size());
      for (std::size_t b = leaf * leaf_size; b < stop; ++b)
        if (boxes_[b].meets(query)) visit(order_[b]);
    });
  }

 private:
  FloatBox relative(const Box3& box) const;
  void group_nodes(std::span<const Index> groups);

  /// Visits leaves from `first` on whose box meets the query, except those whose boxes all belong to `group`. Node k
  /// has the children 2k and 2k+1; leaf l is node n_slots_ + l.
  template <typename Visit>
  void descend(const FloatBox& query, std::size_t first, Index group, Visit&& visit) const {
    if (first >= n_leaves_) return;
    std::array<std::size_t, 64> stack;
    std::array<std::size_t, 64> width;
    std::size_t n = 0;
    stack[n] = 1;
    width[n++] = n_slots_;
    while (n > 0) {
      const std::size_t node = stack[--n], leaves = width[n];
      if (!nodes_[node].meets(query) || (group != no_index && node_groups_[node] == group)) continue;
      if (leaves == 1) {
        visit(node - n_slots_);
        continue;
      }
      const std::size_t half = leaves / 2, right_first = (2 * node + 1) * half - n_slots_;
      if (right_first < n_leaves_) {
        stack[n] = 2 * node + 1;
        width[n++] = half;
      }
      if (right_first > first) {
        stack[n] = 2 * node;
        width[n++] = half;
      }
    }
  }

  Vec3 origin_;
  std::size_t n_leaves_ = 0, n_slots_ = 1;
  std::vector<Index> order_;     ///< the tree's boxes in Morton order
  std::vector<FloatBox> boxes_;  ///< in that order
  std::vector<FloatBox> nodes_;
  std::vector<Index> groups_;       ///< group of each box in Morton order; empty if there are no groups
  std::vector<Index> node_groups_;  ///< for each tree node: the group to which all its boxes belong, or no_index
};

}  // namespace geomesh::geomodel::arrangement
