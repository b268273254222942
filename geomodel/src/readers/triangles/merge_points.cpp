// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/triangles/merge_points.hpp"

#include <bit>
#include <cstdint>

namespace geomesh::geomodel {
namespace {

std::uint64_t mix(std::uint64_t h) {
  h ^= h >> 33;
  h *= 0xff51afd7ed558ccdULL;
  h ^= h >> 33;
  return h;
}

std::uint64_t hash_of(const Vec3& p) {
  std::uint64_t h = 0;
  // Equal points must have equal hashes; adding 0 turns a coordinate -0 into 0.
  for (std::size_t i = 0; i < 3; ++i) h = mix(h * 31 + std::bit_cast<std::uint64_t>(p[i] + 0.0));
  return h;
}

}  // namespace

std::vector<VertexIndex> merge_equal_points(const std::vector<Vec3>& points, std::vector<Vec3>& merged) {
  const std::size_t n_slots = std::bit_ceil(2 * points.size() + 2);
  std::vector<VertexIndex> slot(n_slots, no_vertex);
  std::vector<VertexIndex> row;
  row.reserve(points.size());
  for (const Vec3& p : points) {
    std::size_t s = hash_of(p) & (n_slots - 1);
    while (slot[s] != no_vertex && !(merged[slot[s]] == p)) s = (s + 1) & (n_slots - 1);
    if (slot[s] == no_vertex) {
      slot[s] = static_cast<VertexIndex>(merged.size());
      merged.push_back(p);
    }
    row.push_back(slot[s]);
  }
  return row;
}

}  // namespace geomesh::geomodel
