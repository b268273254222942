// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds the nearest of many points in a plane.
#pragma once

#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// A grid of cells, searched in rings around the query point: constant time for evenly spaced points.
class NearestPlace {
 public:
  explicit NearestPlace(const std::vector<Vec3>& places);
  /// Returns the index of the point nearest to (x, y), the first of equally near ones. Precondition: there is at least
  /// one.
  Index find(double x, double y) const;

 private:
  std::size_t column(double x) const;
  std::size_t row(double y) const;
  void look_into(std::size_t i, std::size_t j, double x, double y, double& best, Index& found) const;
  double distance2_of_cell(std::size_t i, std::size_t j, double x, double y) const;

  const std::vector<Vec3>& places_;
  Box3 bounds_;
  std::size_t n_ = 1;  ///< cells each way
  double width_ = 0, height_ = 0;
  std::vector<std::vector<Index>> cells_;
};

}  // namespace geomesh::geomodel
