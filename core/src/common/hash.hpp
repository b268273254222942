// SPDX-License-Identifier: MIT
/// @file
/// Hashes for tables. No result may depend on them unless a header says so.
#pragma once

#include <array>
#include <cstdint>

namespace geomesh {

inline constexpr std::array<std::uint64_t, 3> hash_factors{0x9E3779B97F4A7C15ull, 0xD6E8FEB86659FD93ull,
                                                           0xC2B2AE3D27D4EB4Full};

/// Hashes up to three numbers quickly; its low bits are good enough for a table with a power of two slots.
template <class Number, std::size_t N>
constexpr std::uint64_t hash_of(const std::array<Number, N>& key) {
  static_assert(N <= hash_factors.size());
  std::uint64_t h = 0;
  for (std::size_t i = 0; i < N; ++i) h ^= key[i] * hash_factors[i];
  return h ^ h >> 32;
}

/// Returns a well-mixed hash, by the finaliser of splitmix64 (Steele, Lea and Flood 2014).
constexpr std::uint64_t mixed(std::uint64_t h) {
  h = (h ^ h >> 30) * 0xBF58476D1CE4E5B9ull;
  h = (h ^ h >> 27) * 0x94D049BB133111EBull;
  return h ^ h >> 31;
}

}  // namespace geomesh
