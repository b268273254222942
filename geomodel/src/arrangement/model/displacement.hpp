// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Sums how far points were moved.
#pragma once

#include "geomesh/geomodel/arrangement.hpp"

namespace geomesh::geomodel::arrangement {

/// Number, sum and largest of the movements of points in one step of the arrangement.
class MovesOfStep {
 public:
  void note(double distance, const Vec3& where) {
    ++moved_.points_moved;
    sum_ += distance;
    if (distance <= moved_.largest) return;
    moved_.largest = distance;
    moved_.where = where;
  }
  Displacement displacement() const {
    Displacement moved = moved_;
    if (moved.points_moved > 0) moved.mean = sum_ / static_cast<double>(moved.points_moved);
    return moved;
  }

 private:
  Displacement moved_;
  double sum_ = 0;
};

/// Adds largest movements of two arrangement steps. A point may move once per step, so the sum is an upper bound.
inline void add(const Displacement& more, Displacement& total) {
  if (more.largest > total.largest) total.where = more.where;
  total.largest += more.largest;
  const auto n = static_cast<double>(total.points_moved + more.points_moved);
  if (n > 0)
    total.mean =
        (total.mean * static_cast<double>(total.points_moved) + more.mean * static_cast<double>(more.points_moved)) / n;
  total.points_moved += more.points_moved;
}

}  // namespace geomesh::geomodel::arrangement
