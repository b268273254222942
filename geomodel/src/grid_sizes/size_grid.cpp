// SPDX-License-Identifier: GPL-3.0-or-later
#include "grid_sizes/size_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace geomesh::geomodel {
namespace {

constexpr std::size_t n_neighbours = 8;

double squared(const Vec3& a, const Vec3& b) { return dot(a - b, a - b); }

/// Returns the interval of ascending nodes that contains v, after clamping v to their range, and the relative position
/// of v in it.
std::pair<std::size_t, double> interval(const std::vector<double>& nodes, double v) {
  if (nodes.size() < 2 || v <= nodes.front()) return {0, 0.0};
  if (v >= nodes.back()) return {nodes.size() - 2, 1.0};
  const auto i = static_cast<std::size_t>(std::upper_bound(nodes.begin(), nodes.end(), v) - nodes.begin()) - 1;
  return {i, (v - nodes[i]) / (nodes[i + 1] - nodes[i])};
}

}  // namespace

SizeGrid::SizeGrid(std::vector<Vec3> points, std::vector<double> sizes)
    : points_(std::move(points)), sizes_(std::move(sizes)) {
  if (make_lattice()) return;
  order_.resize(points_.size());
  std::iota(order_.begin(), order_.end(), Index{0});
  sort_tree(0, static_cast<Index>(order_.size()), 0);
}

bool SizeGrid::make_lattice() {
  std::size_t n = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const Vec3& p : points_) axes_[k].push_back(p[k]);
    std::sort(axes_[k].begin(), axes_[k].end());
    axes_[k].erase(std::unique(axes_[k].begin(), axes_[k].end()), axes_[k].end());
    if (axes_[k].size() > points_.size() / n) return false;  // too few points for a lattice with all these coordinates
    n *= axes_[k].size();
  }
  if (n != points_.size()) return false;
  constexpr double no_point = std::numeric_limits<double>::quiet_NaN();  // sizes are finite
  std::vector<double> at_node(n, no_point);
  for (std::size_t row = 0; row < points_.size(); ++row) {
    std::size_t node = 0;
    for (std::size_t k = 3; k-- > 0;) {
      const auto at = std::lower_bound(axes_[k].begin(), axes_[k].end(), points_[row][k]) - axes_[k].begin();
      node = node * axes_[k].size() + static_cast<std::size_t>(at);
    }
    if (!std::isnan(at_node[node])) return false;  // two points coincide, so some lattice node has no point
    at_node[node] = sizes_[row];
  }
  lattice_ = std::move(at_node);
  return true;
}

void SizeGrid::sort_tree(Index begin, Index end, unsigned axis) {
  if (end - begin < 2) return;
  const Index middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](Index a, Index b) {
    return points_[a][axis] != points_[b][axis] ? points_[a][axis] < points_[b][axis] : a < b;
  });
  sort_tree(begin, middle, (axis + 1) % 3);
  sort_tree(middle + 1, end, (axis + 1) % 3);
}

/// `heap` contains the nearest points so far, with the farthest of them on top.
void SizeGrid::find_nearest(const Vec3& p, Index begin, Index end, unsigned axis, std::vector<Near>& heap) const {
  if (begin >= end) return;
  const Index middle = begin + (end - begin) / 2, row = order_[middle];
  const Near here{squared(points_[row], p), row};
  if (heap.size() < n_neighbours || here < heap.front()) {
    if (heap.size() == n_neighbours) std::pop_heap(heap.begin(), heap.end()), heap.pop_back();
    heap.push_back(here);
    std::push_heap(heap.begin(), heap.end());
  }
  const double off = p[axis] - points_[row][axis];
  const unsigned next = (axis + 1) % 3;
  off < 0 ? find_nearest(p, begin, middle, next, heap) : find_nearest(p, middle + 1, end, next, heap);
  if (heap.size() < n_neighbours || off * off <= heap.front().squared_distance)
    off < 0 ? find_nearest(p, middle + 1, end, next, heap) : find_nearest(p, begin, middle, next, heap);
}

double SizeGrid::weighted(const Vec3& p) const {
  std::vector<Near> nearest;
  find_nearest(p, 0, static_cast<Index>(order_.size()), 0, nearest);
  std::sort(nearest.begin(), nearest.end());
  if (nearest[0].squared_distance == 0) return sizes_[nearest[0].row];
  double sum = 0, weights = 0;
  for (const Near& n : nearest) {
    const double w = nearest[0].squared_distance / n.squared_distance;  // the weight: at most 1, so it cannot overflow
    sum += w * sizes_[n.row];
    weights += w;
  }
  return sum / weights;
}

double SizeGrid::on_lattice(const Vec3& p) const {
  std::array<std::pair<std::size_t, double>, 3> at;
  for (std::size_t k = 0; k < 3; ++k) at[k] = interval(axes_[k], p[k]);
  double size = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::size_t node = 0;
    for (std::size_t k = 3; k-- > 0;) {
      const bool upper = (corner >> k) & 1u;
      weight *= upper ? at[k].second : 1 - at[k].second;
      node = node * axes_[k].size() + std::min(at[k].first + (upper ? 1 : 0), axes_[k].size() - 1);
    }
    if (weight > 0) size += weight * lattice_[node];
  }
  return size;
}

double SizeGrid::at(const Vec3& p) const { return is_lattice() ? on_lattice(p) : weighted(p); }

}  // namespace geomesh::geomodel
