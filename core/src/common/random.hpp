// SPDX-License-Identifier: MIT
/// @file
/// The one generator of choices: the same from the same seed on every machine. Good enough to walk, to shuffle and to
/// try places by, and cheap enough for each step of a walk.
#pragma once

#include <cstdint>

namespace geomesh {

/// Linear congruential, modulo 2^32; its high bits are used.
class Random {
 public:
  explicit constexpr Random(std::uint32_t seed = 1) : state_(seed) {}
  /// Of 2^8 values.
  constexpr unsigned byte() { return advance() >> 24; }
  /// Below n, which is at most 2^16.
  constexpr unsigned below(unsigned n) { return (advance() >> 16) % n; }
  /// Of 2^24 values from low on, below high.
  constexpr double between(double low, double high) { return low + (high - low) * 0x1p-24 * (advance() >> 8); }

 private:
  constexpr std::uint32_t advance() { return state_ = state_ * 1664525u + 1013904223u; }
  std::uint32_t state_;
};

}  // namespace geomesh
