// SPDX-License-Identifier: MIT
/// @file
/// Open-addressing tables of vertex tuples (edges, faces): they are queried once per flip, mostly for absent tuples, so
/// a look-up should read one cache line. Listings are sorted, so that no result depends on hashes.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "common/geometry.hpp"
#include "common/hash.hpp"

namespace geomesh {

/// Map from N vertices, in any order, to an index. Linear probing, load at most one half.
template <std::size_t N>
class SimplexMap {
 public:
  using Key = std::array<VertexIndex, N>;

  /// Returns the value that is stored for a tuple of vertices, in any order of them; no_index if there is none.
  Index find(const Key& vertices) const {
    if (slots_.empty()) return no_index;
    const Slot& slot = slots_[place_of(sorted(vertices))];
    return slot.value >= erased ? no_index : slot.value;
  }
  /// Stores the value for a tuple of vertices, in any order of them, in place of any earlier value.
  void insert(const Key& vertices, Index value) {
    if (2 * (n_used_ + 1) > slots_.size()) grow_to(std::max<std::size_t>(16, 2 * slots_.size()));
    const Key key = sorted(vertices);
    Slot& slot = slots_[place_of(key)];
    n_used_ += slot.value == empty;
    slot = {key, value};
  }
  void erase(const Key& vertices) {
    if (slots_.empty()) return;
    Slot& slot = slots_[place_of(sorted(vertices))];
    if (slot.value != empty) slot.value = erased;
  }
  void reserve(std::size_t n) {
    const std::size_t size = std::bit_ceil(std::max<std::size_t>(16, 2 * n + 2));
    if (slots_.size() < size) grow_to(size);
  }
  /// Ascending.
  std::vector<Key> sorted_keys() const {
    std::vector<Key> keys;
    for (const Slot& s : slots_)
      if (s.value < erased) keys.push_back(s.key);
    std::sort(keys.begin(), keys.end());
    return keys;
  }

 private:
  static constexpr Index empty = no_index, erased = no_index - 1;
  struct Slot {
    Key key{};
    Index value = empty;
  };

  /// Returns the slot that holds the key or in which it would be inserted. Erased keys keep their slots.
  std::size_t place_of(const Key& key) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = hash_of(key) & mask;
    while (slots_[i].value != empty && !are_equal(slots_[i].key, key)) i = (i + 1) & mask;
    return i;
  }
  /// Compares the vertices one by one, because std::array would compare three vertices by a call of memcmp.
  static bool are_equal(const Key& a, const Key& b) {
    VertexIndex difference = 0;
    for (std::size_t i = 0; i < N; ++i) difference |= a[i] ^ b[i];
    return difference == 0;
  }
  void grow_to(std::size_t size) {
    std::vector<Slot> old(size);
    old.swap(slots_);
    n_used_ = 0;
    for (const Slot& s : old) {
      if (s.value >= erased) continue;
      slots_[place_of(s.key)] = s;
      ++n_used_;
    }
  }

  std::vector<Slot> slots_;
  std::size_t n_used_ = 0;
};

class DirectedEdgeSet {
 public:
  using Edge = std::array<VertexIndex, 2>;

  bool contains(const Edge& e) const { return !slots_.empty() && slots_[place_of(pack(e))] != empty; }
  bool insert(const Edge& e) {
    if (2 * (n_ + 1) > slots_.size()) grow();
    const std::size_t i = place_of(pack(e));
    if (slots_[i] != empty) return false;
    slots_[i] = pack(e);
    ++n_;
    return true;
  }

 private:
  static constexpr std::uint64_t empty = ~std::uint64_t{0};

  static std::uint64_t pack(const Edge& e) { return std::uint64_t{e[0]} << 32 | e[1]; }
  std::size_t place_of(std::uint64_t key) const {
    std::size_t i = hash_of(std::array{key}) & (slots_.size() - 1);
    while (slots_[i] != empty && slots_[i] != key) i = (i + 1) & (slots_.size() - 1);
    return i;
  }
  void grow() {
    std::vector<std::uint64_t> old(std::max<std::size_t>(32, 2 * slots_.size()), empty);
    old.swap(slots_);
    for (const std::uint64_t key : old)
      if (key != empty) slots_[place_of(key)] = key;
  }

  std::vector<std::uint64_t> slots_;
  std::size_t n_ = 0;
};

using EdgeMap = SimplexMap<2>;
using FaceMap = SimplexMap<3>;

}  // namespace geomesh
