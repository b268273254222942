// SPDX-License-Identifier: MIT
/// @file
/// How far surfaces may be from the input, by place: a length everywhere, or a share of the target size at the place.
#pragma once

#include <span>

#include "geomesh/core/size_field.hpp"
#include "search/recent_places.hpp"

namespace geomesh::remesh {

class LocalTolerance {
 public:
  LocalTolerance() = default;
  /// One tolerance everywhere.
  explicit LocalTolerance(double everywhere) : greatest_(everywhere) {}
  /// `by_place` contains tolerances that are nowhere larger than `greatest`.
  LocalTolerance(double greatest, SizeField by_place)
      : greatest_(greatest), by_place_(std::move(by_place)), varies_(true) {}

  /// Returns the upper limit of the tolerance at all places.
  double greatest() const { return greatest_; }
  double least_at(std::span<const Vec3> points) const;
  /// Returns the smallest tolerance at the given points; faster if places are repeated.
  double least_at(std::span<const Vec3> points, search::RecentPlaces& recent) const;
  /// Returns an upper bound of the tolerance on a triangle, or on an edge of a curve (the last two corners are equal).
  double most_on(const std::array<Vec3, 3>& corners) const;

 private:
  double greatest_ = 0;
  SizeField by_place_;
  bool varies_ = false;
};

}  // namespace geomesh::remesh
