// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Collects defects of a mesh, all of one kind, that several threads find chunk by chunk, and reports them in order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace geomesh::geomodel {

/// Counts mesh defects of one kind and keeps the first few indices. Lists of chunks are joined in the order of the
/// chunks, so that messages do not depend on the threads.
class FaultList {
 public:
  explicit FaultList(std::string what) : what_(std::move(what)) {}

  void add(std::size_t row) {
    if (++count_ <= most_rows_told) rows_.push_back(row);
  }
  void append(const FaultList& later) {
    count_ += later.count_;
    const std::size_t room = most_rows_told - std::min(most_rows_told, rows_.size());
    rows_.insert(rows_.end(), later.rows_.begin(),
                 later.rows_.begin() + static_cast<std::ptrdiff_t>(std::min(room, later.rows_.size())));
  }
  const std::string& what() const { return what_; }
  /// Appends to `faults` one sentence with the number of defects and their first indices; nothing if there is none.
  void flush(std::vector<std::string>& faults) const {
    if (count_ == 0) return;
    std::string text = std::to_string(count_) + " " + what_ + " (rows ";
    for (std::size_t i = 0; i < rows_.size(); ++i) text += (i == 0 ? "" : ", ") + std::to_string(rows_[i]);
    faults.push_back(text + (count_ > most_rows_told ? ", ...)" : ")"));
  }

 private:
  static constexpr std::size_t most_rows_told = 5;
  std::string what_;
  std::vector<std::size_t> rows_;
  std::size_t count_ = 0;
};

}  // namespace geomesh::geomodel
