// SPDX-License-Identifier: MIT
/// @file
/// Distances of points and triangles from a surface.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

/// Returns the point of the triangle nearest to p. Corners of the triangle may coincide. O(1).
Vec3 closest_on_triangle(const Vec3& p, const std::array<Vec3, 3>& triangle);

/// A triangulated surface with a tree of boxes to search for distances. Triangles may have zero area. Not thread-safe.
class SurfaceDistance {
 public:
  /// O(n log n).
  SurfaceDistance(std::span<const Vec3> points, std::span<const Triangle> triangles);
  ~SurfaceDistance();
  SurfaceDistance(SurfaceDistance&&) noexcept;
  SurfaceDistance& operator=(SurfaceDistance&&) noexcept;

  bool empty() const;
  /// Returns the nearest point of the surface, which must not be empty. O(log n).
  Vec3 closest(const Vec3& p) const;
  /// Returns the triangle that contains the surface point nearest to p; always the same one if several do. O(log n).
  Index closest_triangle(const Vec3& p) const;
  /// Returns whether the whole triangle, and not only samples of it, is proven to be closer than `limit` to the
  /// surface. Returns false also if this could not be decided. A millionth of the limit is reserved for rounding.
  bool is_within(const std::array<Vec3, 3>& triangle, double limit) const;

 private:
  struct Search;
  std::unique_ptr<Search> search_;
};

}  // namespace geomesh
