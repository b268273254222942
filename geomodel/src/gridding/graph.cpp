// SPDX-License-Identifier: GPL-3.0-or-later
#include "gridding/graph.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace geomesh::geomodel {

Frame graph_frame(const std::vector<Vec3>& points, GraphOver over) {
  if (over == GraphOver::map || points.empty()) return {};
  Vec3 centre;
  for (const Vec3& p : points) centre = centre + (1.0 / static_cast<double>(points.size())) * (p - points.front());
  centre = points.front() + centre;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) {
    const Eigen::Vector3d d(p.x - centre.x, p.y - centre.y, p.z - centre.z);
    covariance += d * d.transpose();
  }
  const Eigen::Vector3d w = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().col(0);
  Vec3 normal{w.x(), w.y(), w.z()};
  const double leading = std::abs(normal.z) > 1e-9 ? normal.z : std::abs(normal.y) > 1e-9 ? normal.y : normal.x;
  if (leading < 0) normal = -1.0 * normal;
  return frame_of_normal(centre, normal);
}

namespace {

constexpr std::size_t triangles_a_bucket = 2;

}  // namespace

TriangleFinder::TriangleFinder(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
    : points_(points), triangles_(triangles) {
  Box3 bounds;
  for (const Triangle& t : triangles)
    for (const VertexIndex v : t) bounds.add(points[v]);
  if (bounds.empty()) return;
  u0_ = bounds.min.x;
  v0_ = bounds.min.y;
  const double width = bounds.max.x - bounds.min.x, height = bounds.max.y - bounds.min.y;
  const double n_wanted = static_cast<double>(triangles.size() / triangles_a_bucket + 1);
  size_ = std::max({std::sqrt(width * height / n_wanted), width / 4096, height / 4096});
  if (!(size_ > 0)) size_ = 1;
  n_u_ = static_cast<std::size_t>(width / size_) + 1;
  n_v_ = static_cast<std::size_t>(height / size_) + 1;
  const auto for_each_bucket = [&](const Triangle& t, auto&& visit) {
    Box3 b;
    for (const VertexIndex v : t) b.add(points_[v]);
    const std::size_t low = bucket(b.min.x, b.min.y), high = bucket(b.max.x, b.max.y);
    for (std::size_t j = low / n_u_; j <= high / n_u_; ++j)
      for (std::size_t i = low % n_u_; i <= high % n_u_; ++i) visit(j * n_u_ + i);
  };
  first_.assign(n_u_ * n_v_ + 1, 0);
  for (const Triangle& t : triangles_) for_each_bucket(t, [&](std::size_t b) { ++first_[b + 1]; });
  for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
  rows_.resize(first_.back());
  std::vector<std::size_t> at(first_.begin(), first_.end() - 1);
  for (Index t = 0; t < triangles_.size(); ++t)
    for_each_bucket(triangles_[t], [&](std::size_t b) { rows_[at[b]++] = t; });
}

std::size_t TriangleFinder::bucket(double u, double v) const {
  const auto clamped = [](double x, std::size_t n) {
    return static_cast<std::size_t>(std::clamp(x, 0.0, static_cast<double>(n - 1)));
  };
  return clamped((v - v0_) / size_, n_v_) * n_u_ + clamped((u - u0_) / size_, n_u_);
}

std::optional<double> TriangleFinder::height(double u, double v) const {
  if (first_.empty()) return std::nullopt;
  const std::size_t b = bucket(u, v);
  for (std::size_t k = first_[b]; k < first_[b + 1]; ++k) {
    const Triangle& t = triangles_[rows_[k]];
    const Vec3 &p = points_[t[0]], &q = points_[t[1]], &r = points_[t[2]];
    const auto area = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
    const double whole = area(q.x - p.x, q.y - p.y, r.x - p.x, r.y - p.y);
    if (whole == 0) continue;
    const double s = area(u - p.x, v - p.y, r.x - p.x, r.y - p.y) / whole,
                 w = area(q.x - p.x, q.y - p.y, u - p.x, v - p.y) / whole;
    // Relative slack, with which a point on an edge is found in a triangle of this edge whatever the direction of
    // rounding.
    constexpr double slack = 1e-12;
    if (s < -slack || w < -slack || s + w > 1 + slack) continue;
    return p.z + s * (q.z - p.z) + w * (r.z - p.z);
  }
  return std::nullopt;
}

}  // namespace geomesh::geomodel
