// SPDX-License-Identifier: MIT
/// @file
/// Determines over which lengths a surface is flat within a tolerance, regardless of the angles between its triangles.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::remesh {

/// On a rough surface, the angles between adjacent triangles show the curvature of the noise. For a size, only the
/// distance of the surface from a plane over that size matters. It is measured as the root mean square over the area in
/// a block of 3 x 3 x 3 grid cells around the place, which is as wide as the size.
class FlatExtent {
 public:
  struct Face {
    std::array<Vec3, 3> corners;
    Index patch;
  };
  /// `faces` are those of all surfaces of a mesh. Whether they are flat is examined over lengths up to `widest` only.
  FlatExtent(std::vector<Face> faces, double widest) : faces_(std::move(faces)), widest_(widest) {}

  /// Returns the largest of the lengths `widest`, widest / 2, widest / 4, ... over which the patch around the place is
  /// within the tolerance of a plane, or 0 if none above `least` is. O(log n), plus, once for each grid cell, the faces
  /// in the block around it.
  double at(Index patch, const Vec3& place, double least, double tolerance);

 private:
  struct Entry {
    std::array<std::int64_t, 4> cell;  ///< grid cell: the patch, then the columns in x, y and z
    Index face;
  };
  struct Level {
    double cell = 0;             ///< width
    std::vector<Entry> entries;  ///< sorted
    /// RMS distance of the surface around a grid cell from its best plane, stored at the cell's first entry; -1: none.
    std::vector<double> off;
  };
  Level& level(unsigned number);
  double off_plane(Level& level, Index patch, const Vec3& place);
  double measure(const Level& level, const std::array<std::int64_t, 4>& middle, const Vec3& place) const;

  std::vector<Face> faces_;
  double widest_;
  std::vector<Level> levels_;
};

}  // namespace geomesh::remesh
