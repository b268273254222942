// SPDX-License-Identifier: MIT
/// @file
/// Open-addressing map from sorted vertex tuples (edges, faces) to an index: the declared constraints are looked up
/// once per flip, so the lookup has to be one cache line. Never iterated, so that nothing depends on the order of
/// hashes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::recover {

/// Key of N vertices, in any order. Linear probing, load at most one half.
template <std::size_t N>
class SimplexMap {
 public:
  using Key = std::array<VertexIndex, N>;

  Index find(Key key) const {
    if (slots_.empty()) return no_index;
    std::sort(key.begin(), key.end());
    for (std::size_t i = hash(key) & mask(); slots_[i].value != empty; i = (i + 1) & mask())
      if (slots_[i].key == key) return slots_[i].value == erased ? no_index : slots_[i].value;
    return no_index;
  }
  /// Overwrites an existing entry.
  void insert(Key key, Index value) {
    if (2 * (n_used_ + 1) > slots_.size()) grow();
    std::sort(key.begin(), key.end());
    std::size_t i = hash(key) & mask();
    while (slots_[i].value != empty && slots_[i].key != key) i = (i + 1) & mask();
    if (slots_[i].value == empty) ++n_used_;
    slots_[i] = {key, value};
  }
  void erase(Key key) {
    if (slots_.empty()) return;
    std::sort(key.begin(), key.end());
    for (std::size_t i = hash(key) & mask(); slots_[i].value != empty; i = (i + 1) & mask())
      if (slots_[i].key == key) slots_[i].value = erased;
  }
  void reserve(std::size_t n) {
    while (slots_.size() < 2 * n + 2) grow();
  }

 private:
  static constexpr Index empty = no_index, erased = no_index - 1;
  struct Slot {
    Key key{};
    Index value = empty;
  };

  static std::size_t hash(const Key& key) {
    std::uint64_t h = 0x9E3779B97F4A7C15ull;
    for (VertexIndex v : key) {
      h = (h ^ v) * 0xD6E8FEB86659FD93ull;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }
  std::size_t mask() const { return slots_.size() - 1; }
  void grow() {
    std::vector<Slot> old(std::max<std::size_t>(16, 2 * slots_.size()));
    old.swap(slots_);
    n_used_ = 0;
    for (const Slot& s : old)
      if (s.value != empty && s.value != erased) insert(s.key, s.value);
  }

  std::vector<Slot> slots_;
  std::size_t n_used_ = 0;
};

/// Set of edges with a direction. Open addressing as above; never iterated either.
class DirectedEdgeSet {
 public:
  using Edge = std::array<VertexIndex, 2>;

  bool contains(const Edge& e) const { return !slots_.empty() && slots_[place_of(pack(e))] != empty; }
  /// Whether it was not there.
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
    std::uint64_t h = key * 0xD6E8FEB86659FD93ull;
    h ^= h >> 32;
    std::size_t i = h & (slots_.size() - 1);
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

}  // namespace geomesh::recover
