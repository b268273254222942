// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Surfaces as graphs w(u, v) over the map or a mean plane.
#pragma once

#include <optional>
#include <vector>

#include "geomesh/geomodel/gridding.hpp"
#include "rules/planar/borders.hpp"

namespace geomesh::geomodel {

/// Returns the frame in which points form a graph: the map, or the plane fitted by least squares. w is the direction of
/// least extent, upward unless it is horizontal.
Frame graph_frame(const std::vector<Vec3>& points, GraphOver over);

/// Finds the triangle at a place of the (u, v) plane. Built in nearly linear time; a query costs the contents of one
/// bucket.
class TriangleFinder {
 public:
  TriangleFinder(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
  /// Returns the height w at the place on the first triangle that contains it (borders included); empty if there is
  /// none.
  std::optional<double> height(double u, double v) const;

 private:
  std::size_t bucket(double u, double v) const;

  const std::vector<Vec3>& points_;
  const std::vector<Triangle>& triangles_;
  double u0_ = 0, v0_ = 0, size_ = 1;
  std::size_t n_u_ = 1, n_v_ = 1;
  std::vector<std::size_t> first_;  ///< first entry of each bucket in rows_
  std::vector<Index> rows_;
};

}  // namespace geomesh::geomodel
