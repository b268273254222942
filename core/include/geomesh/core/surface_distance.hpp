// SPDX-License-Identifier: MIT
/// @file
/// How far places and triangles are from a surface.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

/// Point of the triangle nearest to p. Corners may be equal. O(1).
Vec3 closest_on_triangle(const Vec3& p, const std::array<Vec3, 3>& triangle);

/// A surface of triangles, searched by boxes. Triangles may have no area. For one thread.
class SurfaceDistance {
 public:
  /// O(n log n).
  SurfaceDistance(std::span<const Vec3> points, std::span<const Triangle> triangles);
  ~SurfaceDistance();
  SurfaceDistance(SurfaceDistance&&) noexcept;
  SurfaceDistance& operator=(SurfaceDistance&&) noexcept;

  bool empty() const;
  /// The nearest point of the surface, which is not empty. O(log n).
  Vec3 closest(const Vec3& p) const;
  /// The row of the triangle on which that point is; of several the same one each time. O(log n).
  Index closest_triangle(const Vec3& p) const;
  /// Whether all of the triangle is proven to be within the limit of the surface, and not at samples only. False where
  /// a point of it is not, and where that was not decided. A millionth of the limit is left for rounding.
  bool is_within(const std::array<Vec3, 3>& triangle, double limit) const;

 private:
  struct Search;
  std::unique_ptr<Search> search_;
};

}  // namespace geomesh
