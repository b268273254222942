// SPDX-License-Identifier: MIT
/// @file
/// The only random number generator of the program. The same seed gives the same numbers on every machine. The numbers
/// are good enough for walks through a mesh, shuffling and trial positions, and cheap enough for each step of a walk.
#pragma once

#include <cstdint>

namespace geomesh {

/// Linear congruential generator modulo 2^32, whose high bits are used.
class Random {
 public:
  explicit constexpr Random(std::uint32_t seed = 1) : state_(seed) {}
  /// Returns a random number from 0 to 255.
  constexpr unsigned byte() { return advance() >> 24; }
  /// Returns a random number below n, which is at most 2^16.
  constexpr unsigned below(unsigned n) { return (advance() >> 16) % n; }
  /// Returns a random number, one of 2^24 values in [low, high).
  constexpr double between(double low, double high) { return low + (high - low) * 0x1p-24 * (advance() >> 8); }

 private:
  constexpr std::uint32_t advance() { return state_ = state_ * 1664525u + 1013904223u; }
  std::uint32_t state_;
};

}  // namespace geomesh
