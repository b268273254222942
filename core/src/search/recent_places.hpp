// SPDX-License-Identifier: MIT
/// @file
/// What a function has at places that it was asked for lately.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "common/hash.hpp"
#include "geomesh/core/geometry.hpp"

namespace geomesh::search {

/// One memory is for one function, whose values are not negative, and for one thread: neighbours share their corners.
/// No result depends on what is remembered.
class RecentPlaces {
 public:
  struct Known {
    Vec3 place;
    double value = -1;  ///< negative: nothing is known
  };
  /// The value at p; `value_at(last)` computes it where it is not known, with what was asked for last.
  template <class ValueAt>
  double at(const Vec3& p, const ValueAt& value_at) {
    const std::array bits{std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y),
                          std::bit_cast<std::uint64_t>(p.z)};
    Known& known = known_[mixed(hash_of(bits)) % n_known];
    if (known.value < 0 || !(known.place == p)) known = {p, value_at(last_)};
    last_ = known;
    return known.value;
  }
  void clear() { *this = {}; }

 private:
  static constexpr std::size_t n_known = 1024;
  std::vector<Known> known_ = std::vector<Known>(n_known);
  Known last_;
};

}  // namespace geomesh::search
