// SPDX-License-Identifier: MIT
/// @file
/// Marks on cells, or vertices, that cost nothing to clear.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace geomesh {

/// What is marked has the number of the present epoch. One a thread.
class EpochMarks {
 public:
  /// Takes all marks off; indices below n may be marked.
  void begin(std::size_t n) {
    if (stamp_.size() < n) stamp_.resize(n + n / 4, 0);
    if (++epoch_ != 0) return;
    std::fill(stamp_.begin(), stamp_.end(), 0);
    epoch_ = 1;
  }
  bool marked(std::uint32_t i) const { return i < stamp_.size() && stamp_[i] == epoch_; }
  void mark(std::uint32_t i) { stamp_[i] = epoch_; }
  void unmark(std::uint32_t i) { stamp_[i] = 0; }
  /// Whether it was not marked.
  bool mark_first(std::uint32_t i) {
    if (marked(i)) return false;
    mark(i);
    return true;
  }

 private:
  std::vector<std::uint32_t> stamp_;
  std::uint32_t epoch_ = 0;
};

}  // namespace geomesh
