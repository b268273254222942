// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrangement/search/bvh.hpp"

#include <algorithm>
#include <limits>

#include "common/parallel.hpp"

namespace geomesh::geomodel::arrangement {
namespace {

std::uint64_t spread_bits(std::uint64_t v) {
  v &= 0x1FFFFF;
  v = (v | v << 32) & 0x1F00000000FFFFull;
  v = (v | v << 16) & 0x1F0000FF0000FFull;
  v = (v | v << 8) & 0x100F00F00F00F00Full;
  v = (v | v << 4) & 0x10C30C30C30C30C3ull;
  return (v | v << 2) & 0x1249249249249249ull;
}

struct KeyedBox {
  std::uint64_t key;
  Index group, box;
  bool operator<(const KeyedBox& o) const {
    return group != o.group ? group < o.group : key != o.key ? key < o.key : box < o.box;
  }
};

}  // namespace

FloatBox BoxTree::relative(const Box3& box) const {
  FloatBox result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.lo[i] = static_cast<float>(box.min[i] - origin_[i]);
    result.hi[i] = static_cast<float>(box.max[i] - origin_[i]);
  }
  return result;
}

BoxTree::BoxTree(const std::vector<Box3>& boxes, std::span<const Index> groups) {
  Box3 all;
  for (const Box3& b : boxes) {
    all.add(b.min);
    all.add(b.max);
  }
  if (boxes.empty()) return;
  origin_ = all.min;
  double extent = 0;
  for (std::size_t i = 0; i < 3; ++i) extent = std::max(extent, all.max[i] - all.min[i]);
  const double scale = extent > 0 ? 0.5 * 0x1FFFFF / extent : 0;
  std::vector<KeyedBox> keyed(boxes.size());
  parallel_for(boxes.size(), [&](std::size_t i) {
    std::uint64_t key = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double middle = (boxes[i].min[k] - origin_[k]) + (boxes[i].max[k] - origin_[k]);
      key |= spread_bits(static_cast<std::uint64_t>(std::clamp(middle * scale, 0.0, double{0x1FFFFF}))) << k;
    }
    keyed[i] = {key, groups.empty() ? no_index : groups[i], static_cast<Index>(i)};
  });
  parallel_sort(keyed.begin(), keyed.end());

  n_leaves_ = (boxes.size() + leaf_size - 1) / leaf_size;
  while (n_slots_ < n_leaves_) n_slots_ *= 2;
  order_.resize(boxes.size());
  boxes_.resize(boxes.size());
  constexpr float inf = std::numeric_limits<float>::infinity();
  const FloatBox empty{{inf, inf, inf}, {-inf, -inf, -inf}};
  nodes_.assign(2 * n_slots_, empty);
  parallel_for(n_leaves_, [&](std::size_t leaf) {
    FloatBox node = empty;
    for (std::size_t i = leaf * leaf_size; i < std::min((leaf + 1) * leaf_size, boxes.size()); ++i) {
      order_[i] = keyed[i].box;
      boxes_[i] = relative(boxes[order_[i]]);
      node.add(boxes_[i]);
    }
    nodes_[n_slots_ + leaf] = node;
  });
  for (std::size_t node = n_slots_; node-- > 1;) {
    nodes_[node] = nodes_[2 * node];
    nodes_[node].add(nodes_[2 * node + 1]);
  }
  if (!groups.empty()) group_nodes(groups);
}

void BoxTree::group_nodes(std::span<const Index> groups) {
  groups_.resize(order_.size());
  for (std::size_t i = 0; i < order_.size(); ++i) groups_[i] = groups[order_[i]];
  // Nodes of the tree without boxes are never visited, so their group does not matter.
  node_groups_.assign(2 * n_slots_, no_index);
  for (std::size_t leaf = 0; leaf < n_leaves_; ++leaf) {
    const std::size_t begin = leaf * leaf_size, end = std::min(begin + leaf_size, groups_.size());
    if (groups_[begin] == groups_[end - 1])
      node_groups_[n_slots_ + leaf] = groups_[begin];  // the leaf's boxes are sorted by group, so there is only one
  }
  for (std::size_t node = n_slots_; node-- > 1;)
    if (node_groups_[2 * node] == node_groups_[2 * node + 1]) node_groups_[node] = node_groups_[2 * node];
}

}  // namespace geomesh::geomodel::arrangement
