// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Faces, edges and places used as keys of maps.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <unordered_map>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh::app {

using Corners = std::array<VertexIndex, 3>;

inline Corners sorted_corners(const Triangle& t) {
  Corners c{t[0], t[1], t[2]};
  std::sort(c.begin(), c.end());
  return c;
}

using Edge = std::array<VertexIndex, 2>;
inline Edge sorted_edge(VertexIndex a, VertexIndex b) { return a < b ? Edge{a, b} : Edge{b, a}; }

/// Returns the face opposite vertex i, counter-clockwise as seen from the tetrahedron.
inline Triangle face_at(const Tetrahedron& t, unsigned i) {
  return {t[face_vertices[i][0]], t[face_vertices[i][1]], t[face_vertices[i][2]]};
}

/// Hash of a point. Points are the same if their coordinates are equal, bit by bit except for the sign of zero.
struct PlaceHash {
  std::size_t operator()(const Vec3& p) const {
    std::uint64_t h = 0;
    for (const double x : {p.x, p.y, p.z}) {
      h ^= std::bit_cast<std::uint64_t>(x + 0.0);
      h *= 0x9E3779B97F4A7C15u;
      h ^= h >> 29;
    }
    return h;
  }
};
template <class T>
using ByPlace = std::unordered_map<Vec3, T, PlaceHash>;

inline bool is_before(const Vec3& a, const Vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

}  // namespace geomesh::app
