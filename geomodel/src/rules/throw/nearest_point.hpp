// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the nearest of many points.
#pragma once

#include <cstdint>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// A tree that halves the points along the longest side of their bounding box (J. L. Bentley, Multidimensional binary
/// search trees used for associative searching, Comm. ACM 18, 1975). O(n log n) to build, O(log n) per query.
class NearestPoint {
 public:
  explicit NearestPoint(std::vector<Vec3> points);
  /// Returns the index of the point nearest to p, the first of equally near ones; no_index if there are no points.
  Index find(const Vec3& p) const;

 private:
  struct Best {
    Index row = no_index;
    double distance = 0;
  };
  void build(std::size_t begin, std::size_t end);
  /// Searches the points [begin, end) of the tree. `off` is the vector from p to their bounding box, along each axis.
  void find(std::size_t begin, std::size_t end, const Vec3& p, const Vec3& off, Best& best) const;
  void look_at(Index row, const Vec3& p, Best& best) const;

  std::vector<Vec3> points_;
  Box3 bounds_;
  std::vector<Index> rows_;         ///< halved in place
  std::vector<std::uint8_t> axis_;  ///< axis along which each range of points was halved, at the index of its middle
};

}  // namespace geomesh::geomodel
