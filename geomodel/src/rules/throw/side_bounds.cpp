// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/throw/side_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/by_rounding.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::size_t few = 8;  // number of planes per leaf of the tree, which is not divided further

}  // namespace

SideBounds::SideBounds(std::vector<SidedPlane> planes) {
  if (planes.empty()) return;
  Box3 bounds;
  for (SidedPlane& plane : planes) {
    bounds.add(plane.point);
    const double l = norm(plane.normal);
    plane.normal = l > 0 ? (1 / l) * plane.normal : Vec3{};
  }
  centre_ = 0.5 * (bounds.min + bounds.max);
  extent_ = norm(bounds.max - bounds.min);
  build(planes, 0, planes.size());
}

std::size_t SideBounds::build(std::vector<SidedPlane>& planes, std::size_t begin, std::size_t end) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::size_t row = nodes_.size();
  Node node{{}, infinite, -infinite, 0};
  Box3 box;
  for (std::size_t i = begin; i < end; ++i) {
    node.normals.add(planes[i].normal);
    box.add(planes[i].point);
    const double offset = dot(planes[i].point - centre_, planes[i].normal);
    node.least_offset = std::min(node.least_offset, offset);
    node.most_offset = std::max(node.most_offset, offset);
  }
  nodes_.push_back(node);
  if (end - begin <= few) return row;
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (box.max[k] - box.min[k] > box.max[axis] - box.min[axis]) axis = k;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return planes.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end),
                   [&](const SidedPlane& a, const SidedPlane& b) { return a.point[axis] < b.point[axis]; });
  build(planes, begin, middle);
  const std::size_t right = build(planes, middle, end);
  nodes_[row].right = right;
  return row;
}

SideOfAll SideBounds::side(std::size_t node, const Vec3& from_centre, double tiny) const {
  const Node& n = nodes_[node];
  double least = -n.most_offset, most = -n.least_offset;
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = from_centre[k] * n.normals.min[k], b = from_centre[k] * n.normals.max[k];
    least += std::min(a, b);
    most += std::max(a, b);
  }
  if (least > tiny) return SideOfAll::above;
  if (most < -tiny) return SideOfAll::below;
  if (n.right == 0) return SideOfAll::not_known;
  const SideOfAll first = side(node + 1, from_centre, tiny);
  if (first == SideOfAll::not_known) return first;
  return side(n.right, from_centre, tiny) == first ? first : SideOfAll::not_known;
}

SideOfAll SideBounds::side(const Vec3& p) const {
  if (nodes_.empty()) return SideOfAll::not_known;
  const Vec3 from_centre = p - centre_;
  return side(0, from_centre, by_rounding * (norm(from_centre) + extent_));
}

}  // namespace geomesh::geomodel
