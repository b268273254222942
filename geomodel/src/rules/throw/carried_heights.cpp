// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/throw/carried_heights.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace geomesh::geomodel {
namespace {

constexpr double fit_radius = 3;    // in edges
constexpr double along_counts = 2;  // weight of distances along a fault's strike, relative to those across it
constexpr std::size_t fewest_to_fit = 6;

/// Measures distances in the map from a place, with a larger weight for distances along the strike of a fault.
class AcrossStrike {
 public:
  AcrossStrike(const Vec3& p, const Vec2& across) : p_(p), across_(across) {}
  double to(const Vec3& q) const {
    const Vec3 off = q - p_;
    const double along = off.x * across_.y - off.y * across_.x;
    return std::sqrt(off.x * off.x + off.y * off.y + (along_counts * along_counts - 1) * along * along);
  }

 private:
  Vec3 p_;
  Vec2 across_;
};

}  // namespace

CarriedHeights::CarriedHeights(const TriangulatedSurface& surface, double edge)
    : surface_(surface), edge_(edge), cell_(fit_radius * edge) {}

std::pair<std::int64_t, std::int64_t> CarriedHeights::cell_of(double x, double y) const {
  return {std::llround(std::floor(x / cell_)), std::llround(std::floor(y / cell_))};
}

void CarriedHeights::add(VertexIndex node) {
  const Vec3& p = surface_.points[node];
  cells_[cell_of(p.x, p.y)].push_back(node);
}

template <class F>
void CarriedHeights::for_each_near(const Vec3& p, double radius, F&& visit) const {
  const auto [i0, j0] = cell_of(p.x - radius, p.y - radius);
  const auto [i1, j1] = cell_of(p.x + radius, p.y + radius);
  for (std::int64_t i = i0; i <= i1; ++i)
    for (std::int64_t j = j0; j <= j1; ++j) {
      const auto at = cells_.find({i, j});
      if (at == cells_.end()) continue;
      for (const VertexIndex v : at->second) visit(surface_.points[v]);
    }
}

std::optional<double> CarriedHeights::at(const Vec3& p, const Vec2& across, double reach) const {
  const AcrossStrike distance(p, across);
  double nearest = reach;
  for_each_near(p, reach, [&](const Vec3& q) { nearest = std::min(nearest, distance.to(q)); });
  if (!(nearest < reach)) return std::nullopt;
  Eigen::Matrix3d matrix;
  Eigen::Vector3d side;
  std::size_t n = 0;
  for (double radius = fit_radius * edge_; n < fewest_to_fit; radius *= 2) {
    if (radius > reach) return std::nullopt;
    matrix.setZero(), side.setZero(), n = 0;
    for_each_near(p, nearest + 2 * radius, [&](const Vec3& node) {
      const double d = distance.to(node);
      if (d > nearest + 2 * radius) return;
      const double off = (d - nearest) / radius, weight = std::exp(-off * off);
      const Vec3 q = node - p;
      const Eigen::Vector3d terms(1, q.x / edge_, q.y / edge_);
      matrix += weight * terms * terms.transpose();
      side += weight * q.z * terms;
      ++n;
    });
  }
  const Eigen::Vector3d fitted = matrix.completeOrthogonalDecomposition().solve(side);
  return p.z + fitted[0];
}

}  // namespace geomesh::geomodel
