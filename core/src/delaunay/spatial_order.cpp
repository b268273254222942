// SPDX-License-Identifier: MIT
#include "delaunay/spatial_order.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace geomesh {
namespace {

/// Hilbert index of a cell of a 2^bits grid in 3D (Skilling 2004, "Programming the Hilbert curve").
std::uint64_t hilbert_index(std::array<std::uint32_t, 3> x, int bits) {
  for (std::uint32_t q = 1u << (bits - 1); q > 1; q >>= 1) {
    const std::uint32_t p = q - 1;
    for (auto& xi : x) {
      if (xi & q) {
        x[0] ^= p;
      } else {
        const std::uint32_t t = (x[0] ^ xi) & p;
        x[0] ^= t;
        xi ^= t;
      }
    }
  }
  x[1] ^= x[0];
  x[2] ^= x[1];
  std::uint32_t t = 0;
  for (std::uint32_t q = 1u << (bits - 1); q > 1; q >>= 1)
    if (x[2] & q) t ^= q - 1;
  for (auto& xi : x) xi ^= t;
  std::uint64_t index = 0;
  for (int b = bits - 1; b >= 0; --b)
    for (const auto xi : x) index = index << 1 | (xi >> b & 1u);
  return index;
}

/// A well mixed hash of the coordinates: decides the round, so that the order does not depend on the numbering.
std::uint64_t coordinate_hash(const Vec3& p) {
  std::uint64_t h = 0x9E3779B97F4A7C15ull;
  for (std::size_t i = 0; i < 3; ++i) {
    h ^= std::bit_cast<std::uint64_t>(p[i] + 0.0);
    h *= 0xBF58476D1CE4E5B9ull;
    h ^= h >> 31;
    h *= 0x94D049BB133111EBull;
    h ^= h >> 29;
  }
  return h;
}

}  // namespace

std::vector<VertexIndex> spatial_order(std::span<const Vec3> points, std::vector<VertexIndex> subset) {
  constexpr int bits = 20;
  Box3 box;
  for (const VertexIndex v : subset) box.add(points[v]);
  Vec3 scale;
  for (std::size_t i = 0; i < 3; ++i) {
    const double extent = box.max[i] - box.min[i];
    scale[i] = extent > 0 ? ((1 << bits) - 1) / extent : 0;
  }
  struct Key {
    std::uint64_t round_and_place;
    VertexIndex v;
  };
  std::vector<Key> keys;
  keys.reserve(subset.size());
  // A round holds 7/8 of what is left: the last round is the largest, and comes last.
  for (const VertexIndex v : subset) {
    const Vec3& p = points[v];
    const auto zeros = static_cast<std::uint64_t>(std::countr_zero(coordinate_hash(p) | (1ull << 24)) / 3);
    std::array<std::uint32_t, 3> cell;
    for (std::size_t i = 0; i < 3; ++i) cell[i] = static_cast<std::uint32_t>((p[i] - box.min[i]) * scale[i]);
    keys.push_back({(8 - zeros) << 60 | hilbert_index(cell, bits), v});
  }
  std::sort(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
    if (a.round_and_place != b.round_and_place) return a.round_and_place < b.round_and_place;
    const Vec3 &p = points[a.v], &q = points[b.v];
    if (p.x != q.x) return p.x < q.x;
    if (p.y != q.y) return p.y < q.y;
    return p.z < q.z;
  });
  for (std::size_t i = 0; i < keys.size(); ++i) subset[i] = keys[i].v;
  return subset;
}

}  // namespace geomesh
