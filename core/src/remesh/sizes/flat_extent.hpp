// SPDX-License-Identifier: MIT
/// @file
/// Over which lengths a surface is flat but for a tolerance, whatever its triangles do at shorter ones.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::remesh {

/// Rough surfaces turn from triangle to triangle by angles whose radius of curvature is that of the noise. What a size
/// asks is how far the surface is off a plane over that size. The measure is the root of the mean square over the area
/// in a block of 3 x 3 x 3 cells about the place. The block is as wide as the size.
class FlatExtent {
 public:
  struct Face {
    std::array<Vec3, 3> corners;
    Index patch;
  };
  /// `widest` is the greatest length that is looked at.
  FlatExtent(std::vector<Face> faces, double widest) : faces_(std::move(faces)), widest_(widest) {}

  /// The first of `widest`, half of it, a quarter, ... over which the patch about the place is within the tolerance of
  /// a plane; 0 where none above `least` is. O(log n) and the faces in a block once for each of its middle cells.
  double at(Index patch, const Vec3& place, double least, double tolerance);

 private:
  struct Entry {
    std::array<std::int64_t, 4> cell;  ///< patch, then columns in x, y and z
    Index face;
  };
  struct Level {
    double cell = 0;             ///< width
    std::vector<Entry> entries;  ///< sorted
    std::vector<double> off;     ///< by entry that is the first of its cell: what was measured, -1: not yet
  };
  Level& level(unsigned number);
  double off_plane(Level& level, Index patch, const Vec3& place);
  double measure(const Level& level, const std::array<std::int64_t, 4>& middle, const Vec3& place) const;

  std::vector<Face> faces_;
  double widest_;
  std::vector<Level> levels_;
};

}  // namespace geomesh::remesh
