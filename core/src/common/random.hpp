// SPDX-License-Identifier: MIT
/// @file
/// The one generator of choices: the same from the same seed on every machine. Good enough to walk and to shuffle by,
/// and cheap enough for each step of a walk. The search for the last bad cells alone has another, since it draws real
/// numbers too (remesh/rescue/openings.hpp).
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

 private:
  constexpr std::uint32_t advance() { return state_ = state_ * 1664525u + 1013904223u; }
  std::uint32_t state_;
};

}  // namespace geomesh
