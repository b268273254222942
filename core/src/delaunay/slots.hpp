// SPDX-License-Identifier: MIT
/// @file
/// Allocates the cells of an insertion: freed slots first, then a range of the mesh.
#pragma once

#include <algorithm>
#include <vector>

#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// Gives out slots for new cells. Each of `n_sources` sources that share the mesh beyond slot `base` owns a part of it:
/// source k owns the blocks k, k + n_sources, ... of `block` slots each. The slots that a source gives out therefore
/// depend only on its own work, and not on the timing of others. The blocks of a single source form one range.
class SlotSource {
 public:
  SlotSource() = default;
  SlotSource(CellIndex base, CellIndex limit, unsigned source, unsigned n_sources)
      : next_(base + source * block), block_end_(next_ + block), limit_(limit), stride_(n_sources * block) {}

  /// Returns true if `n` more slots are available without enlarging the mesh.
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

  /// Returns the end of the last block of cell slots that this source has begun to use.
  CellIndex used_end() const { return block_end_; }
  /// Returns the cell slots below `end` that this source owns and no cell uses: freed ones, then those never used.
  std::vector<CellIndex> unused(CellIndex end) const {
    std::vector<CellIndex> r = free_;
    CellIndex c = next_, stop = block_end_;
    for (; c < end; c = stop - block + stride_, stop = c + block)
      for (; c < std::min(stop, end); ++c) r.push_back(c);
    return r;
  }
  /// Continues with a new range of cell slots from `base`; the rest of the old range is added to the freed slots.
  void restart(CellIndex base, CellIndex limit) {
    for (; next_ < block_end_; ++next_)
      if (next_ < limit_) free_.push_back(next_);
    next_ = base;
    block_end_ = base + block;
    limit_ = limit;
  }
  /// Removes all slots that no cell uses, after the last insertion. Only for the single source of a mesh: its blocks
  /// form one range, so that no slot beyond the next one has been used.
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
