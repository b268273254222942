// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Divides a range of indices into chunks of fixed length, for parallel loops whose results are joined in order.
#pragma once

#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

#include "common/parallel.hpp"

namespace geomesh::geomodel {

/// Runs `work` so that loops of oneTBB use at most the given number of threads (0: all cores).
template <class Work>
void in_arena(unsigned threads, const Work& work) {
  const int cores = tbb::this_task_arena::max_concurrency();
  tbb::task_arena arena(threads == 0 ? cores : std::min(cores, static_cast<int>(threads)));
  arena.execute(work);
}

/// Calls task(k) for k in [0, n) on several threads. Tasks must not modify each other's data.
template <class Task>
void for_each_task(std::size_t n, unsigned threads, const Task& task) {
  in_arena(threads, [&] { parallel_for(n, [&](std::size_t k) { task(k); }); });
}

/// Divides the indices [0, n) into chunks that do not depend on the number of threads.
class Chunks {
 public:
  explicit Chunks(std::size_t n) : n_(n) {}
  std::size_t size() const { return (n_ + rows - 1) / rows; }
  /// Calls task(k, begin, end) for each chunk of the indices [0, n): chunk k has those in [begin, end).
  template <class Task>
  void for_each(unsigned threads, const Task& task) const {
    for_each_task(size(), threads, [&](std::size_t k) { task(k, k * rows, std::min(n_, (k + 1) * rows)); });
  }

 private:
  static constexpr std::size_t rows = 65536;
  std::size_t n_;
};

}  // namespace geomesh::geomodel
