// SPDX-License-Identifier: MIT
/// @file
/// Marks on a few of many cells or vertices. All marks are cleared in constant time.
#pragma once

#include <cstdint>
#include <vector>

namespace geomesh {

/// A hash table that fits into the nearest cache, because only few items are marked at a time (a star, a cavity). An
/// array indexed by cell would cause scattered memory access. An entry is valid only in the epoch in which it was made.
/// Use one object per thread. Calls take constant time unless the table grows; at most half of its slots are used.
class EpochMarks {
 public:
  /// Clears the marks of all cells or vertices.
  void begin() {
    n_ = 0;
    if (++epoch_ < epochs) return;
    table_.assign(table_.size(), {});
    epoch_ = 1;
  }
  bool marked(std::uint32_t i) const {
    const Entry& e = table_[place_of(i)];
    return is_of_epoch(e) && is_on(e);
  }
  void mark(std::uint32_t i) { set(i, true); }
  void unmark(std::uint32_t i) { set(i, false); }
  /// Marks i and returns whether it was not marked before.
  bool mark_first(std::uint32_t i) {
    Entry& e = table_[place_of(i)];
    if (!is_of_epoch(e)) {
      add(e, i, true);
      return true;
    }
    if (is_on(e)) return false;
    e.stamp |= 1u;
    return true;
  }

 private:
  struct Entry {
    std::uint32_t index = 0, stamp = 0;  ///< `stamp`: 2 * (epoch of the entry) + (1 if `index` is marked)
  };
  static constexpr std::uint32_t epochs = std::uint32_t{1} << 31;
  static constexpr unsigned first_bits = 9;

  bool is_of_epoch(const Entry& e) const { return e.stamp >> 1 == epoch_; }
  static bool is_on(const Entry& e) { return (e.stamp & 1u) != 0; }

  /// Returns the slot of the hash table that holds the mark of item i, or the free slot where it would be inserted.
  std::size_t place_of(std::uint32_t i) const {
    const std::size_t mask = table_.size() - 1;
    std::size_t at = (i * 0x9E3779B1u) >> (32 - bits_);
    while (is_of_epoch(table_[at]) && table_[at].index != i) at = (at + 1) & mask;
    return at;
  }
  void set(std::uint32_t i, bool on) {
    Entry& e = table_[place_of(i)];
    if (is_of_epoch(e))
      e.stamp = epoch_ << 1 | static_cast<std::uint32_t>(on);
    else if (on)
      add(e, i, on);
  }
  void add(Entry& e, std::uint32_t i, bool on) {
    e = {i, epoch_ << 1 | static_cast<std::uint32_t>(on)};
    if (2 * ++n_ > table_.size()) grow();
  }
  void grow() {
    const std::vector<Entry> old(std::move(table_));
    ++bits_;
    table_.assign(std::size_t{1} << bits_, {});
    for (const Entry& e : old)
      if (is_of_epoch(e)) table_[place_of(e.index)] = e;
  }

  unsigned bits_ = first_bits;
  std::vector<Entry> table_ = std::vector<Entry>(std::size_t{1} << first_bits);
  std::uint32_t epoch_ = 1;
  std::size_t n_ = 0;
};

}  // namespace geomesh
