// SPDX-License-Identifier: MIT
/// @file
/// Plain geometric value types used throughout the core.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace geomesh {

/// A point or vector in doubles, elevation up, in the unit of the model.
struct Vec3 {
  double x = 0, y = 0, z = 0;
  constexpr double operator[](std::size_t i) const { return i == 0 ? x : i == 1 ? y : z; }
  constexpr double& operator[](std::size_t i) { return i == 0 ? x : i == 1 ? y : z; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;  ///< coordinates -0 and 0 are equal
};

/// A point in two dimensions, in the plane of a facet or on a map.
struct Vec2 {
  double x = 0, y = 0;
  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Closed axis-aligned box; empty (min > max) when default-constructed.
struct Box3 {
  Vec3 min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
           std::numeric_limits<double>::infinity()};
  Vec3 max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
           -std::numeric_limits<double>::infinity()};
  constexpr bool empty() const { return min.x > max.x || min.y > max.y || min.z > max.z; }
  constexpr void add(const Vec3& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (p[i] < min[i]) min[i] = p[i];
      if (p[i] > max[i]) max[i] = p[i];
    }
  }
};

/// The sign of an exactly evaluated expression. All decisions on topology are based on such signs.
enum class Sign : int { negative = -1, zero = 0, positive = 1 };
constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }
constexpr Sign operator*(Sign a, Sign b) { return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b)); }

/// Index of a vertex in an array of points; `no_vertex` if there is none.
using VertexIndex = std::uint32_t;
inline constexpr VertexIndex no_vertex = 0xFFFFFFFFu;

/// Index of anything but a vertex (a segment, a facet, a region ...); `no_index` if there is none.
using Index = std::uint32_t;
inline constexpr Index no_index = 0xFFFFFFFFu;

using Triangle = std::array<VertexIndex, 3>;
using Tetrahedron = std::array<VertexIndex, 4>;

}  // namespace geomesh
