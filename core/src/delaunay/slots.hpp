// SPDX-License-Identifier: MIT
/// @file
/// Where the cells of an insertion come from: freed slots first, then a range of the mesh.
#pragma once

#include <algorithm>
#include <vector>

#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// One of `n_sources` sources that share the mesh beyond `base`: source k owns the blocks k, k + n_sources, ... of
/// `block` slots each. So the slots a source hands out depend on its own work alone, not on when the others ran. With
/// one source the blocks join to one range.
class SlotSource {
 public:
  SlotSource() = default;
  SlotSource(CellIndex base, CellIndex limit, unsigned source, unsigned n_sources)
      : next_(base + source * block), block_end_(next_ + block), limit_(limit), stride_(n_sources * block) {}

  /// True where `n` more slots can be taken without a larger mesh.
  bool has(std::size_t n) const {
    std::size_t free = free_.size() + (block_end_ <= limit_ ? block_end_ - next_ : 0);
    for (std::size_t b = std::size_t{block_end_} - block + stride_; free < n && b + block <= limit_; b += stride_)
      free += block;
    return free >= n;
  }
  CellIndex take() {
    if (!free_.empty()) {
      const CellIndex c = free_.back();
      free_.pop_back();
      return c;
    }
    if (next_ == block_end_) {
      next_ = block_end_ - block + stride_;
      block_end_ = next_ + block;
    }
    return next_++;
  }
  void give_back(CellIndex c) { free_.push_back(c); }
  void raise_limit(CellIndex limit) { limit_ = limit; }

  /// One past the last slot of the blocks used.
  CellIndex used_end() const { return block_end_; }
  /// Slots of this source below `end` that no cell uses: freed ones, then never used ones.
  std::vector<CellIndex> unused(CellIndex end) const {
    std::vector<CellIndex> r = free_;
    CellIndex c = next_, stop = block_end_;
    for (; c < end; c = stop - block + stride_, stop = c + block)
      for (; c < std::min(stop, end); ++c) r.push_back(c);
    return r;
  }
  /// Goes on with a new range from `base`; what is left of the old one joins the freed slots.
  void restart(CellIndex base, CellIndex limit) {
    for (; next_ < block_end_; ++next_)
      if (next_ < limit_) free_.push_back(next_);
    next_ = base;
    block_end_ = base + block;
    limit_ = limit;
  }
  /// The only source of a mesh, at the end: drops all slots that no cell uses. Its blocks are one range, so none beyond
  /// the next slot has been used.
  template <class Mesh>
  void finish(Mesh& mesh) const {
    for (const CellIndex c : free_)
      if (c < next_) mesh.cells()[c].vertices[0] = no_vertex;
    mesh.drop_slots_from(std::min(next_, mesh.n_slots()));
    mesh.compact();
  }
  void adopt(const std::vector<CellIndex>& slots) { free_.insert(free_.end(), slots.rbegin(), slots.rend()); }

  static constexpr CellIndex block = 1024;

 private:
  std::vector<CellIndex> free_;
  CellIndex next_ = 0, block_end_ = 0, limit_ = 0, stride_ = block;
};

}  // namespace geomesh
