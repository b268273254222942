// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Represents surfaces as graphs w(u, v) over the map or over a mean plane.
#pragma once

#include <optional>
#include <vector>

#include "geomesh/geomodel/gridding.hpp"
#include "rules/planar/borders.hpp"

namespace geomesh::geomodel {

/// Returns the frame (u, v, w) in which points form a graph: the map, or the plane fitted by least squares. The axis w
/// has the direction of least extent, and points upward unless it is horizontal.
Frame graph_frame(const std::vector<Vec3>& points, GraphOver over);

/// Finds the triangle that contains a point of the (u, v) plane. Building takes nearly linear time; a query examines
/// the triangles of one bucket.
class TriangleFinder {
 public:
  TriangleFinder(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
  /// Returns the height w of the first triangle that contains the point (u, v), borders included; empty if none does.
  std::optional<double> height(double u, double v) const;

 private:
  std::size_t bucket(double u, double v) const;

  const std::vector<Vec3>& points_;
  const std::vector<Triangle>& triangles_;
  double u0_ = 0, v0_ = 0, size_ = 1;
  std::size_t n_u_ = 1, n_v_ = 1;
  std::vector<std::size_t> first_;
  std::vector<Index> rows_;
};

}  // namespace geomesh::geomodel
