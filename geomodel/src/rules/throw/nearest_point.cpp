// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/throw/nearest_point.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/by_rounding.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::size_t few = 8;  // number of points of a leaf of the tree, which is searched linearly

}  // namespace

NearestPoint::NearestPoint(std::vector<Vec3> points)
    : points_(std::move(points)), rows_(points_.size()), axis_(points_.size(), 0) {
  for (const Vec3& p : points_) bounds_.add(p);
  std::iota(rows_.begin(), rows_.end(), Index{0});
  build(0, rows_.size());
}

void NearestPoint::build(std::size_t begin, std::size_t end) {
  if (end - begin <= few) return;
  Box3 box;
  for (std::size_t i = begin; i < end; ++i) box.add(points_[rows_[i]]);
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (box.max[k] - box.min[k] > box.max[axis] - box.min[axis]) axis = k;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return rows_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](Index a, Index b) {
    return points_[a][axis] != points_[b][axis] ? points_[a][axis] < points_[b][axis] : a < b;
  });
  axis_[middle] = static_cast<std::uint8_t>(axis);
  build(begin, middle);
  build(middle + 1, end);
}

void NearestPoint::look_at(Index row, const Vec3& p, Best& best) const {
  const Vec3 off = p - points_[row];
  const double squared = dot(off, off);
  if (best.row != no_index && squared > (1 + by_rounding) * best.distance * best.distance) return;
  const double d = std::sqrt(squared);
  if (best.row == no_index || d < best.distance || (d == best.distance && row < best.row)) best = {row, d};
}

void NearestPoint::find(std::size_t begin, std::size_t end, const Vec3& p, const Vec3& off, Best& best) const {
  if (end - begin <= few) {
    for (std::size_t i = begin; i < end; ++i) look_at(rows_[i], p, best);
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2, axis = axis_[middle];
  look_at(rows_[middle], p, best);
  const double beyond = p[axis] - points_[rows_[middle]][axis];
  const bool is_low = beyond < 0;
  find(is_low ? begin : middle + 1, is_low ? middle : end, p, off, best);
  Vec3 further = off;
  further[axis] = std::max(off[axis], std::abs(beyond));
  if ((1 - by_rounding) * dot(further, further) <= best.distance * best.distance)
    find(is_low ? middle + 1 : begin, is_low ? end : middle, p, further, best);
}

Index NearestPoint::find(const Vec3& p) const {
  Best best;
  Vec3 off{0, 0, 0};
  for (std::size_t k = 0; k < 3 && !points_.empty(); ++k)
    off[k] = std::max({0.0, bounds_.min[k] - p[k], p[k] - bounds_.max[k]});
  find(0, rows_.size(), p, off, best);
  return best.row;
}

}  // namespace geomesh::geomodel
