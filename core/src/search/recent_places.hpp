// SPDX-License-Identifier: MIT
/// @file
/// Remembers the values of a function at places where it was evaluated recently.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "common/hash.hpp"
#include "geomesh/core/geometry.hpp"

namespace geomesh::search {

/// A cache of the values of one function that is never negative, for one thread. It helps because neighbouring
/// triangles share their corners. No result depends on what is remembered.
class RecentPlaces {
 public:
  /// Makes a cache for at most `n_places` places with their values; `n_places` must be above 0.
  explicit RecentPlaces(std::size_t n_places = 1024) : known_(n_places) {}
  struct Known {
    Vec3 place;
    double value = -1;  ///< function value at `place`; negative if none is stored
  };
  /// Returns the function's value at p: the stored one or value_at(last); `last` has the previous place and its value.
  template <class ValueAt>
  double at(const Vec3& p, const ValueAt& value_at) {
    const std::array bits{std::bit_cast<std::uint64_t>(p.x), std::bit_cast<std::uint64_t>(p.y),
                          std::bit_cast<std::uint64_t>(p.z)};
    Known& known = known_[mixed(hash_of(bits)) % known_.size()];
    if (known.value < 0 || !(known.place == p)) known = {p, value_at(last_)};
    last_ = known;
    return known.value;
  }
  void clear() {
    std::ranges::fill(known_, Known());
    last_ = {};
  }

 private:
  std::vector<Known> known_;
  Known last_;
};

}  // namespace geomesh::search
