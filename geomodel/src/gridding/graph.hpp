// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Surfaces as graphs w(u, v) over the map or a mean plane.
#pragma once

#include <optional>
#include <vector>

#include "geomesh/geomodel/gridding.hpp"
#include "rules/planar/borders.hpp"

namespace geomesh::geomodel {

/// The frame in which points are a graph: the map, or the plane of least squares through them. w is the direction of
/// least extent, upward where it is not horizontal.
Frame graph_frame(const std::vector<Vec3>& points, GraphOver over);

/// Finds the triangle over which a place of the (u, v) plane lies. Built in near-linear time; a query costs what lies
/// in one bucket.
class TriangleFinder {
 public:
  TriangleFinder(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
  /// The height w over the place: of the first triangle that contains it (borders included); empty where there is none.
  std::optional<double> height(double u, double v) const;

 private:
  std::size_t bucket(double u, double v) const;

  const std::vector<Vec3>& points_;
  const std::vector<Triangle>& triangles_;
  double u0_ = 0, v0_ = 0, size_ = 1;
  std::size_t n_u_ = 1, n_v_ = 1;
  std::vector<std::size_t> first_;  ///< per bucket, into rows_
  std::vector<Index> rows_;
};

}  // namespace geomesh::geomodel
