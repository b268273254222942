// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Loops and sorting with oneTBB. The thread sanitizer does not see into that library and would miss the order of
/// events. If it is active, loops run on separate threads instead, and sorting on one thread.
#pragma once

#include <cstddef>

#if defined(__SANITIZE_THREAD__)
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#else
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#endif

namespace geomesh::geomodel {

#if defined(__SANITIZE_THREAD__)

template <class Task>
void parallel_for(std::size_t n, const Task& task) {
  const auto cores = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
  const std::size_t allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  std::atomic<std::size_t> next{0};
  std::mutex failing;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      for (std::size_t k; (k = next++) < n;) task(k);
    } catch (...) {
      const std::lock_guard lock(failing);
      if (!failure) failure = std::current_exception();
      next = n;
    }
  };
  std::vector<std::thread> workers;
  for (std::size_t t = 1; t < std::min({cores, allowed, n}); ++t) workers.emplace_back(work);
  work();
  for (std::thread& worker : workers) worker.join();
  if (failure) std::rethrow_exception(failure);
}

template <class Iterator, class... Less>
void parallel_sort(Iterator begin, Iterator end, const Less&... less) {
  std::sort(begin, end, less...);
}

#else

/// Calls task(k) for k in [0, n) on the threads of the arena. The first exception of a task is passed to the caller.
template <class Task>
void parallel_for(std::size_t n, const Task& task) {
  tbb::parallel_for(std::size_t{0}, n, task);
}

/// Sorts like std::sort, in parallel, for random-access iterators.
template <class Iterator, class... Less>
void parallel_sort(Iterator begin, Iterator end, const Less&... less) {
  tbb::parallel_sort(begin, end, less...);
}

#endif

}  // namespace geomesh::geomodel
