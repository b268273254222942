// SPDX-License-Identifier: MIT
/// @file
/// The curve classes of edges, by their vertices.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::remesh {

/// A table from edges (in either direction, of two different vertices) to curve classes, by open addressing: asked for
/// many edges that are on no curve, so a miss must be quick. What is erased keeps its slot.
class CurveEdges {
 public:
  /// no_index where the edge is none.
  Index find(VertexIndex a, VertexIndex b) const {
    if (slots_.empty()) return no_index;
    return slots_[slot_of(key_of(a, b))].curve;
  }
  void set(VertexIndex a, VertexIndex b, Index curve) {
    if (2 * (n_used_ + 1) > slots_.size()) grow();
    Slot& slot = slots_[slot_of(key_of(a, b))];
    n_used_ += slot.key == 0;
    slot = {key_of(a, b), curve};
  }
  void erase(VertexIndex a, VertexIndex b) {
    if (!slots_.empty()) slots_[slot_of(key_of(a, b))].curve = no_index;
  }
  /// In ascending order of their vertices.
  std::vector<std::array<VertexIndex, 2>> sorted() const {
    std::vector<std::array<VertexIndex, 2>> edges;
    for (const Slot& s : slots_)
      if (s.curve != no_index)
        edges.push_back({static_cast<VertexIndex>(s.key >> 32), static_cast<VertexIndex>(s.key)});
    std::sort(edges.begin(), edges.end());
    return edges;
  }

 private:
  struct Slot {
    std::uint64_t key = 0;  ///< 0: never used
    Index curve = no_index;
  };
  static std::uint64_t key_of(VertexIndex a, VertexIndex b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  }
  /// Where the key is or would go.
  std::size_t slot_of(std::uint64_t key) const {
    std::size_t at = ((key * 0x9E3779B97F4A7C15u ^ (key >> 32) * 0xC2B2AE3D27D4EB4Fu) >> 32) & (slots_.size() - 1);
    while (slots_[at].key != 0 && slots_[at].key != key) at = (at + 1) & (slots_.size() - 1);
    return at;
  }
  void grow() {
    std::vector<Slot> old(std::max<std::size_t>(64, 2 * slots_.size()));
    old.swap(slots_);
    n_used_ = 0;
    for (const Slot& s : old) {
      if (s.curve == no_index) continue;
      slots_[slot_of(s.key)] = s;
      ++n_used_;
    }
  }

  std::vector<Slot> slots_;  // a power of two of them, at most half used
  std::size_t n_used_ = 0;
};

}  // namespace geomesh::remesh
